#include "libtorch/nets/adam.hpp"

#include <gtest/gtest.h>
#include <torch/optim/adam.h>

#include <cmath>

#include "libtorch/nets/torch.hpp"
#include "support/checkpoints.hpp"

namespace piae::libtorch {
namespace {

// Follows Algorithm 1 of Kingma and Ba for one parameter, with beta 0.9 and 0.999.
TEST(Adam, TakesTheHandWorkedSteps) {
  const torch::Tensor values = torch::full({1}, 1.0, torch::kFloat64);
  const torch::Tensor gradients = torch::zeros({1}, torch::kFloat64);
  Adam adam(values, gradients);

  gradients.fill_(0.5);
  adam.step(0.1);  // m = 0.05, v = 0.00025; corrected 0.5 and 0.25: 1 - 0.1 * 0.5 / 0.5
  EXPECT_NEAR(values.item<double>(), 0.9, 1e-8);

  gradients.fill_(-1.0);
  adam.step(0.1);  // m = -0.055, v = 0.00124975; corrected -0.2894737 and 0.6251876
  const double second = 0.9 + 0.1 * (0.055 / 0.19) / std::sqrt(0.00124975 / 0.001999);
  EXPECT_NEAR(values.item<double>(), second, 1e-8);
  EXPECT_NEAR(values.item<double>(), 0.93661035, 1e-7);

  gradients.fill_(2.0);
  adam.step(0.01);  // m = 0.1505, v = 0.00524850025; 1 - beta^3: 0.271 and 0.002997001
  const double third = second - 0.01 * (0.1505 / 0.271) / std::sqrt(0.00524850025 / 0.002997001);
  EXPECT_NEAR(values.item<double>(), third, 1e-8);
}

TEST(Adam, MatchesLibTorch) {
  torch::Tensor theirs = torch::linspace(-1, 1, 50, torch::kFloat64).requires_grad_();
  const torch::Tensor ours = theirs.detach().clone();
  const torch::Tensor gradients = torch::zeros_like(ours);
  Adam adam(ours, gradients, 0.5, 0.9);
  torch::optim::Adam reference(std::vector<torch::Tensor>{theirs},
                               torch::optim::AdamOptions(0.01).betas({0.5, 0.9}));
  for (int step = 1; step <= 20; ++step) {
    const torch::Tensor gradient = torch::cos(theirs.detach() * step);
    theirs.mutable_grad() = gradient.clone();
    gradients.copy_(gradient);
    reference.step();
    adam.step(0.01);
  }
  EXPECT_LT((ours - theirs.detach()).abs().max().item<double>(), 1e-6);
}

TEST(Adam, ContinuesExactlyFromItsStoredState) {
  const auto gradient_of = [](int step) { return torch::cos(torch::arange(7) * 0.3 + step); };
  const torch::Tensor uncut = torch::zeros({7});
  torch::Tensor gradients = torch::zeros({7});
  Adam one(uncut, gradients);
  torch::Tensor continued;
  const auto path = scratch_file("adam.h5");
  for (int step = 0; step < 6; ++step) {
    gradients.copy_(gradient_of(step));
    one.step(0.01);
    if (step == 2) {
      artefact::Writer writer("model");
      one.write(writer, "/optimiser");
      writer.save(path, {});
      continued = uncut.clone();
    }
  }
  Adam other(continued, gradients);
  other.read(artefact::Reader(path, "model"), "/optimiser");
  for (int step = 3; step < 6; ++step) {
    gradients.copy_(gradient_of(step));
    other.step(0.01);
  }
  EXPECT_TRUE(torch::equal(uncut, continued));
}

TEST(ClipNorm, ScalesLongGradientsOnly) {
  const torch::Tensor gradients = torch::tensor({3.0, 4.0});
  EXPECT_NEAR(clip_norm(gradients, 10.0), 5.0, 1e-6);
  EXPECT_TRUE(torch::equal(gradients, torch::tensor({3.0, 4.0})));
  EXPECT_NEAR(clip_norm(gradients, 1.0), 5.0, 1e-6);
  EXPECT_TRUE(torch::allclose(gradients, torch::tensor({0.6, 0.8})));
}

}  // namespace
}  // namespace piae::libtorch
