#include "libtorch/latent/wgan_gp_losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "latent/specs.hpp"
#include "libtorch/latent/gradients.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {
namespace {

/// Returns a critic of one layer with the given weights on three samples, weights 7 and -5 on two
/// classes, and bias 0.5.
ParameterSet linear_critic(const std::vector<double>& weights) {
  latent::LatentGenerator generator = example_generator(3, 2, 1);
  generator.size.depth = 1;
  ParameterSet parameters = double_parameters(latent::wgan_gp_specs(generator));
  const torch::NoGradGuard no_grad;
  std::vector<double> row = weights;
  row.insert(row.end(), {7, -5});
  const torch::Tensor weight = parameters["net/critic/0/weight"];
  const torch::Tensor bias = parameters["net/critic/0/bias"];
  weight.copy_(torch::tensor(row, torch::kFloat64).unsqueeze(0));
  bias.fill_(0.5);
  return parameters;
}

TEST(GradientPenalty, LinearCriticHasThePenaltyOfItsWeights) {
  // The gradient is (2, -3, 6) everywhere, of norm 7; the weights of the class do not affect it.
  const ParameterSet parameters = linear_critic({2, -3, 6});
  Stream stream("linear");
  const Batch batch = example_batch(stream, 5, 3, 2);
  EXPECT_NEAR(gradient_penalty(parameters, batch.windows, batch.classes).item<double>(), 36, 1e-12);
}

TEST(GradientPenalty, LinearCriticHasTheGradientOfItsClosedForm) {
  // d/dw (|w| - 1)^2 = 2 (1 - 1/|w|) w
  const ParameterSet parameters = linear_critic({2, -3, 6});
  Stream stream("linear");
  const Batch batch = example_batch(stream, 5, 3, 2);
  const torch::Tensor gradient =
      torch::autograd::grad({gradient_penalty(parameters, batch.windows, batch.classes)},
                            {parameters["net/critic/0/weight"]})[0];
  const torch::Tensor expected =
      torch::tensor({{2.0, -3.0, 6.0, 0.0, 0.0}}, torch::kFloat64) * (2 * (1 - 1 / 7.0));
  EXPECT_LT((gradient - expected).abs().max().item<double>(), 1e-12);
}

TEST(GradientPenalty, StaysFiniteForAFlatScore) {
  const ParameterSet parameters = linear_critic({0, 0, 0});
  Stream stream("flat");
  const Batch batch = example_batch(stream, 2, 3, 2);
  const torch::Tensor penalty = gradient_penalty(parameters, batch.windows, batch.classes);
  EXPECT_EQ(penalty.item<double>(), 1);
  EXPECT_TRUE(torch::autograd::grad({penalty}, {parameters["net/critic/0/weight"]})[0]
                  .isfinite()
                  .all()
                  .item<bool>());
}

TEST(GradientPenalty, DoesNotMixTheWindowsOfABatch) {
  const latent::LatentGenerator generator = example_generator(6, 3, 2);
  const ParameterSet parameters = double_parameters(latent::wgan_gp_specs(generator));
  Stream stream("batch");
  const Batch batch = example_batch(stream, 4, 6, 3);
  double sum = 0;
  for (std::int64_t i = 0; i < 4; ++i) {
    sum +=
        gradient_penalty(parameters, batch.windows.narrow(0, i, 1), batch.classes.narrow(0, i, 1))
            .item<double>();
  }
  EXPECT_NEAR(gradient_penalty(parameters, batch.windows, batch.classes).item<double>(), sum / 4,
              1e-12);
}

TEST(CriticLosses, MatchTheHandWorkedLinearCritic) {
  // Scores without class and bias, which cancel: known 2 and 6, generated -3 and 0.
  const ParameterSet parameters = linear_critic({2, -3, 6});
  const Batch known{torch::tensor({{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, torch::kFloat64),
                    torch::tensor({{1.0, 0.0}, {0.0, 1.0}}, torch::kFloat64)};
  const torch::Tensor generated =
      torch::tensor({{0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}}, torch::kFloat64);
  const torch::Tensor share = torch::full({2, 1}, 0.5, torch::kFloat64);
  const CriticLosses losses = critic_losses(parameters, known, generated, share);
  EXPECT_NEAR(losses.wasserstein.item<double>(), (5 + 6) / 2.0, 1e-12);
  EXPECT_NEAR(losses.penalty.item<double>(), 36, 1e-12);
}

TEST(CriticLosses, ComputeThePenaltyBetweenKnownAndGenerated) {
  const latent::LatentGenerator generator = example_generator(6, 3, 2);
  const ParameterSet parameters = double_parameters(latent::wgan_gp_specs(generator));
  Stream stream("between");
  const Batch known = example_batch(stream, 4, 6, 3);
  const torch::Tensor generated = random_tensor(stream, 4, 6);
  const torch::Tensor share = torch::tensor({0.0, 0.25, 0.5, 1.0}, torch::kFloat64).unsqueeze(1);
  const torch::Tensor between = (1 - share) * generated + share * known.windows;
  EXPECT_NEAR(critic_losses(parameters, known, generated, share).penalty.item<double>(),
              gradient_penalty(parameters, between, known.classes).item<double>(), 1e-12);
}

TEST(CriticLosses, GradientEqualsFiniteDifferences) {
  const latent::LatentGenerator generator = example_generator(6, 3, 2);
  const ParameterSet parameters = double_parameters(latent::wgan_gp_specs(generator));
  Stream stream("critic");
  const Batch known = example_batch(stream, 4, 6, 3);
  const torch::Tensor generated = random_tensor(stream, 4, 6);
  const torch::Tensor share = torch::tensor({0.1, 0.4, 0.6, 0.9}, torch::kFloat64).unsqueeze(1);
  const auto loss = [&] {
    const CriticLosses losses = critic_losses(parameters, known, generated, share);
    return 10 * losses.penalty - losses.wasserstein;
  };
  EXPECT_LT(gradient_error(parameters, "net/critic/", loss), 1e-7);
}

}  // namespace
}  // namespace piae::libtorch
