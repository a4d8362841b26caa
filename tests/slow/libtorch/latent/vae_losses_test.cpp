#include "libtorch/latent/vae_losses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "latent/specs.hpp"
#include "libtorch/latent/gradients.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {
namespace {

torch::Tensor row(const std::vector<double>& values) {
  return torch::tensor(values, torch::kFloat64).unsqueeze(0);
}

TEST(KlToStandardNormal, EqualsItsClosedForm) {
  // KL(N(m, s^2) || N(0, 1)) = (m^2 + s^2 - 1) / 2 - log s
  EXPECT_NEAR(kl_to_standard_normal(row({0}), row({0})).item<double>(), 0, 1e-15);
  EXPECT_NEAR(kl_to_standard_normal(row({3}), row({0})).item<double>(), 4.5, 1e-12);
  const double s = 0.4;
  EXPECT_NEAR(kl_to_standard_normal(row({0}), row({2 * std::log(s)})).item<double>(),
              (s * s - 1) / 2 - std::log(s), 1e-12);
}

TEST(KlToStandardNormal, MatchesItsDefiningIntegral) {
  const double m = 0.7;
  const double s = 1.6;
  double integral = 0;
  const double step = 1e-3;  // step of u = (x - m) / s
  for (int i = -12000; i <= 12000; ++i) {
    const double u = i * step;
    const double x = m + u * s;
    const double density = std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi);
    integral += step * density * (-u * u / 2 - std::log(s) + x * x / 2);
  }
  EXPECT_NEAR(kl_to_standard_normal(row({m}), row({2 * std::log(s)})).item<double>(), integral,
              1e-9);
}

TEST(KlToStandardNormal, AddsDimensionsAndAveragesWindows) {
  const torch::Tensor mean = torch::tensor({{1.0, 2.0}, {0.0, 3.0}}, torch::kFloat64);
  EXPECT_NEAR(kl_to_standard_normal(mean, torch::zeros_like(mean)).item<double>(),
              ((1 + 4) / 2.0 + 9 / 2.0) / 2, 1e-12);
}

TEST(VaeLosses, MatchTheHandWorkedNetwork) {
  // One sample, one class, one latent number, single layers: x = 2, q = N(0.5 x, 1) with noise -3,
  // so z = -2; decoded 0.25 z + 1 = 0.5.
  latent::LatentGenerator decoder = example_generator(1, 1, 1);
  decoder.size.depth = 1;
  ParameterSet parameters = double_parameters(latent::vae_specs(decoder));
  {
    const torch::NoGradGuard no_grad;
    parameters.values().zero_();
    parameters["net/encoder/0/weight"][0][0] = 0.5;
    parameters["net/generator/0/weight"][0][0] = 0.25;
    parameters["net/generator/0/bias"][0] = 1;
  }
  const Batch batch{row({2}), row({1})};
  const VaeLosses losses = vae_losses(parameters, batch, row({-3}));
  EXPECT_NEAR(losses.squared_error.item<double>(), 0.5 * 1.5 * 1.5, 1e-12);
  EXPECT_NEAR(losses.kl.item<double>(), 0.5, 1e-12);
}

TEST(VaeLosses, GradientEqualsFiniteDifferences) {
  const latent::LatentGenerator decoder = example_generator(6, 3, 2);
  ParameterSet parameters = double_parameters(latent::vae_specs(decoder));
  Stream stream("vae");
  const Batch batch = example_batch(stream, 4, 6, 3);
  const torch::Tensor noise = random_tensor(stream, 4, 2);
  const auto loss = [&] {
    const VaeLosses losses = vae_losses(parameters, batch, noise);
    return losses.squared_error + losses.kl;
  };
  EXPECT_LT(gradient_error(parameters, "net/", loss), 1e-7);
}

}  // namespace
}  // namespace piae::libtorch
