#include "libtorch/twin/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/random.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/random_tensor.hpp"
#include "twin/example_physics.hpp"

namespace piae::libtorch {
namespace {

using twin::example_physics;

const twin::Stencil central = twin::stencil_of(twin::Derivatives::central);

/// Returns the largest difference between autograd and central differences, relative to the largest
/// gradient.
double gradient_error(const std::function<torch::Tensor(const torch::Tensor&)>& loss,
                      const torch::Tensor& at, double step) {
  const torch::Tensor x = at.clone().requires_grad_();
  const torch::Tensor exact = torch::autograd::grad({loss(x)}, {x})[0];
  const torch::NoGradGuard no_grad;
  const torch::Tensor probe = at.clone();
  const torch::Tensor flat = probe.view(-1);
  double worst = 0;
  for (std::int64_t i = 0; i < flat.numel(); ++i) {
    const auto old = flat[i].item<double>();
    flat[i] = old + step;
    const auto above = loss(probe).item<double>();
    flat[i] = old - step;
    const auto below = loss(probe).item<double>();
    flat[i] = old;
    const double difference = (above - below) / (2 * step);
    worst = std::max(worst, std::abs(difference - exact.view(-1)[i].item<double>()));
  }
  return worst / exact.abs().max().item<double>();
}

TEST(BatchMmd, EqualsTheHandWorkedValue) {
  // Pooled points 0, 1 | 2: squared distances 1, 4, 1, mean over the 6 ordered pairs 2, b = 0.5.
  const torch::Tensor x = torch::tensor({0.0, 1.0}, torch::kFloat64).view({2, 1});
  const torch::Tensor y = torch::tensor({2.0}, torch::kFloat64).view({1, 1});
  double expected = 0;
  for (const double b : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    const double near = std::exp(-1 / b);
    const double far = std::exp(-4 / b);
    expected += (2 + 2 * near) / 4 + 1 - 2 * (far + near) / 2;
  }
  EXPECT_NEAR(batch_mmd(x, y).item<double>(), expected, 1e-12);
}

TEST(BatchMmd, IsZeroForEqualBatches) {
  Stream stream("mmd");
  const torch::Tensor x = random_tensor(stream, 5, 16);
  EXPECT_NEAR(batch_mmd(x, x).item<double>(), 0, 1e-12);
}

TEST(ReconstructionLoss, IsMeanSquareAndMmd) {
  Stream stream("rec");
  const torch::Tensor x = random_tensor(stream, 4, 8);
  const torch::Tensor a = random_tensor(stream, 4, 8);
  const double expected = (x - a).square().mean().item<double>() + batch_mmd(x, a).item<double>();
  EXPECT_NEAR(reconstruction_loss(x, a).item<double>(), expected, 1e-12);
}

TEST(ReconstructionLoss, GradientEqualsFiniteDifferences) {
  Stream stream("rec-gradient");
  const torch::Tensor x = random_tensor(stream, 4, 6);
  const torch::Tensor a = random_tensor(stream, 4, 6);
  EXPECT_LT(gradient_error([&](const auto& t) { return reconstruction_loss(x, t); }, a, 1e-5),
            1e-7);
}

TEST(DifferentialLoss, VanishesForAMotionThatDiffersByDiscretisationOnly) {
  // u = -cos(w t)/w^2, v = sin(w t)/w, a = cos(w t). Difference errors: (w h)^2 / 12 and / 6.
  const double step = 0.01;
  const double omega = 2.0;
  const torch::Tensor t = torch::arange(0, 64, torch::kFloat64) * step;
  const torch::Tensor phase = torch::tensor({0.0, 1.0, 2.0}, torch::kFloat64).unsqueeze(1);
  const torch::Tensor a = torch::cos(omega * t + phase);
  const Motion motion{-a / (omega * omega), torch::sin(omega * t + phase) / omega};
  EXPECT_LT(differential_loss(motion, a, step, central).item<double>(), 1e-6);
  const Motion wrong{motion.displacement * 1.1, motion.velocity};
  EXPECT_GT(differential_loss(wrong, a, step, central).item<double>(), 1e-3);
}

TEST(DifferentialLoss, GradientsEqualFiniteDifferences) {
  Stream stream("ddl-gradient");
  const torch::Tensor u = random_tensor(stream, 3, 8);
  const torch::Tensor v = random_tensor(stream, 3, 8);
  const torch::Tensor a = random_tensor(stream, 3, 8);
  const double h = 0.8;
  EXPECT_LT(gradient_error(
                [&](const auto& t) {
                  return differential_loss({t, v}, a, h, central);
                },
                u, 1e-5),
            1e-7);
  EXPECT_LT(gradient_error(
                [&](const auto& t) {
                  return differential_loss({u, t}, a, h, central);
                },
                v, 1e-5),
            1e-7);
  EXPECT_LT(gradient_error(
                [&](const auto& t) {
                  return differential_loss({u, v}, t, h, central);
                },
                a, 1e-5),
            1e-7);
}

TEST(TwinLoss, VanishesForAFreeDampedOscillation) {
  // Eq. 13 without contact about equilibrium: a + d c v + k u = 0, so u = exp(-b t) cos(w t).
  twin::Physics physics = example_physics();
  physics.contact_n_per_m15 = 0;
  const double k = 3.2;
  const double c = 6.0;
  const double b = physics.damping * c / 2;
  const double w = std::sqrt(k - b * b);
  const torch::Tensor t = torch::arange(0, 200, torch::kFloat64).unsqueeze(0) * 0.05;
  const torch::Tensor decay = torch::exp(-b * t);
  const torch::Tensor u = decay * torch::cos(w * t);
  const torch::Tensor v = -decay * (b * torch::cos(w * t) + w * torch::sin(w * t));
  const torch::Tensor a = -(2 * b * v + k * u);
  const auto batch = batch_physics(physics, torch::tensor({0}, torch::kInt64), torch::kFloat64);
  const torch::Tensor right = torch::tensor({{k, c}}, torch::kFloat64);
  const torch::Tensor wrong = torch::tensor({{k * 1.1, c}}, torch::kFloat64);
  EXPECT_LT(twin_loss(right, a, {u, v}, batch, physics).item<double>(), 1e-20);
  EXPECT_GT(twin_loss(wrong, a, {u, v}, batch, physics).item<double>(), 1e-3);
}

TEST(TwinLoss, ContactAddsItsTangentStiffnessForSmallMotion) {
  const twin::Physics physics = example_physics();
  const double k = 1.5;
  const double s_0 = twin::static_equilibrium_m(k * twin::stiffness_scale_n_per_m,
                                                twin::standing_at(2e-6), physics);
  const double tangent =
      1.5 * physics.contact_n_per_m15 * std::sqrt(s_0 - 2e-6) / twin::stiffness_scale_n_per_m;
  const torch::Tensor u = torch::full({1, 4}, 1e-3, torch::kFloat64);
  const torch::Tensor v = torch::zeros_like(u);
  const torch::Tensor a = -(k + tangent) * u;
  const auto batch = batch_physics(physics, torch::tensor({0}, torch::kInt64), torch::kFloat64);
  const torch::Tensor k_and_c = torch::tensor({{k, 5.0}}, torch::kFloat64);
  const auto residual = std::sqrt(twin_loss(k_and_c, a, {u, v}, batch, physics).item<double>());
  EXPECT_LT(residual, 1e-5 * (k + tangent) * 1e-3);
}

TEST(TwinLoss, GradientsEqualFiniteDifferences) {
  const twin::Physics physics = example_physics();
  Stream stream("dt-gradient");
  const torch::Tensor a = random_tensor(stream, 3, 8);
  const torch::Tensor u = random_tensor(stream, 3, 8);
  const torch::Tensor v = random_tensor(stream, 3, 8);
  const torch::Tensor k_and_c =
      torch::tensor({{0.7, 3.0}, {1.4, 5.0}, {3.0, 9.0}}, torch::kFloat64);
  const auto batch =
      batch_physics(physics, torch::tensor({0, 1, 1}, torch::kInt64), torch::kFloat64);
  const auto loss = [&](const torch::Tensor& kc, const torch::Tensor& acc, const torch::Tensor& dis,
                        const torch::Tensor& vel) {
    return twin_loss(kc, acc, {dis, vel}, batch, physics);
  };
  EXPECT_LT(gradient_error([&](const auto& t) { return loss(t, a, u, v); }, k_and_c, 1e-5), 1e-6);
  EXPECT_LT(gradient_error([&](const auto& t) { return loss(k_and_c, t, u, v); }, a, 1e-5), 1e-7);
  EXPECT_LT(gradient_error([&](const auto& t) { return loss(k_and_c, a, t, v); }, u, 1e-5), 1e-6);
  EXPECT_LT(gradient_error([&](const auto& t) { return loss(k_and_c, a, u, t); }, v, 1e-5), 1e-7);
}

TEST(TwinLoss, GradientStaysFiniteWhereContactIsLost) {
  twin::Physics physics = example_physics();
  physics.contact = {twin::standing_at(1.0),
                     twin::standing_at(1.0)};  // deeper than the load can reach
  const auto batch = batch_physics(physics, torch::tensor({0}, torch::kInt64), torch::kFloat64);
  const torch::Tensor k_and_c = torch::tensor({{1.0, 5.0}}, torch::kFloat64).requires_grad_();
  const torch::Tensor one = torch::ones({1, 4}, torch::kFloat64);
  const torch::Tensor loss = twin_loss(k_and_c, one, {one, one}, batch, physics);
  EXPECT_TRUE(torch::autograd::grad({loss}, {k_and_c})[0].isfinite().all().item<bool>());
}

/// A softplus may underflow to 0 in single precision.
TEST(TwinLoss, StaysFiniteWithItsGradientWithoutStiffness) {
  const twin::Physics physics = example_physics();
  const auto batch = batch_physics(physics, torch::tensor({0}, torch::kInt64), torch::kFloat32);
  const torch::Tensor k_and_c = torch::zeros({1, 2}).requires_grad_();
  const torch::Tensor one = torch::ones({1, 4});
  const torch::Tensor loss = twin_loss(k_and_c, one, {one, one}, batch, physics);
  EXPECT_TRUE(loss.isfinite().item<bool>());
  EXPECT_TRUE(torch::autograd::grad({loss}, {k_and_c})[0].isfinite().all().item<bool>());
}

TEST(TotalLoss, GradientsEqualFiniteDifferences) {
  const auto total = [](const torch::Tensor& l, const torch::Tensor& w) {
    return twin::total_loss<torch::Tensor, torch::Tensor>({l[0], l[1], l[2]}, {w[0], w[1], w[2]});
  };
  const torch::Tensor losses = torch::tensor({0.3, 0.05, 2.0}, torch::kFloat64);
  const torch::Tensor log_weights = torch::tensor({0.1, -0.4, 0.7}, torch::kFloat64);
  const auto of_losses = [&](const torch::Tensor& l) { return total(l, log_weights); };
  const auto of_weights = [&](const torch::Tensor& w) { return total(losses, w); };
  EXPECT_LT(gradient_error(of_losses, losses, 1e-5), 1e-8);
  EXPECT_LT(gradient_error(of_weights, log_weights, 1e-5), 1e-8);
}

}  // namespace
}  // namespace piae::libtorch
