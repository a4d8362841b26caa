// The WGAN-GP for one core: hand-worked linear networks, and gradients by finite differences.

#include "latent/wgan_gp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latent/example_task.hpp"
#include "latent/specs.hpp"
#include "support/gradients.hpp"

namespace piae::latent {
namespace {

const WganGpOptions never_the_generator{.critic_steps = 1000, .penalty = 10};
const WganGpOptions always_the_generator{.critic_steps = 1, .penalty = 10};

std::unique_ptr<LatentBackend> backend_of(const LatentTask& task, const WganGpOptions& options) {
  return wgan_gp(task, options, Stream("initial"), Device::cpu);
}

std::vector<float> moments(const LatentBackend& backend, const std::string& adam) {
  return first_moments([&](artefact::Writer& writer) { backend.write_adam(writer); },
                       "/adam/" + adam);
}

/// Returns windows (1, 0, 0) of class 0 and (0, 0, 1) of class 1, and single layers.
LatentTask linear_task() {
  LatentTask task = example_task(3, 2, 1);
  task.generator.size.depth = 1;
  task.windows = {1, 0, 0, 0, 0, 1};
  task.labels = {0, 1};
  return task;
}

/// A generator that returns (0, 1, 0) for every z and class; a critic with the weights (2, -3, 6)
/// of norm 7 on the samples, 7 and -5 on the classes, and bias 0.5.
const std::vector<float> linear_values{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, -3, 6, 7, -5, 0.5F};
const std::vector<std::size_t> both{0, 1};

TEST(WganGp, HasTheHandWorkedLossesOfALinearCritic) {
  const LatentTask task = linear_task();
  const auto backend = backend_of(task, never_the_generator);
  backend->set_values(linear_values);
  Stream noise("noise");
  const std::vector<double> losses = backend->step(0, both, noise);
  // Scores without class and bias, which cancel: known 2 and 6, generated -3 and -3.
  EXPECT_NEAR(losses[0], 4 + 3, 1e-6);
  EXPECT_NEAR(losses[1], 36, 1e-5);  // (7 - 1)^2
}

// The gradient of -wasserstein + 10 (|w| - 1)^2 by w: mean generated minus mean known, plus 20 (1 -
// 1/|w|) w.
TEST(WganGp, LinearCriticFollowsTheClosedForm) {
  const LatentTask task = linear_task();
  const auto backend = backend_of(task, never_the_generator);
  backend->set_values(linear_values);
  Stream noise("noise");
  backend->step(0, both, noise);
  const double factor = 20 * (1 - 1 / 7.0);
  const double expected[] = {-0.5 + 2 * factor, 1 - 3 * factor, -0.5 + 6 * factor, 0, 0, 0};
  const std::vector<float> gradient = moments(*backend, "critic");
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(gradient.at(i), (1 - wgan_gp_beta1) * expected[i], 1e-4) << i;
  }
}

TEST(WganGp, StaysFiniteForAFlatScore) {
  const LatentTask task = linear_task();
  const auto backend = backend_of(task, never_the_generator);
  std::vector<float> values = linear_values;
  std::fill_n(values.end() - 6, 3, 0.0F);
  backend->set_values(values);
  Stream noise("noise");
  EXPECT_EQ(backend->step(0, both, noise)[1], 1);
  EXPECT_TRUE(std::ranges::all_of(backend->values(), [](float x) { return std::isfinite(x); }));
}

// The derivative of the mean score of windows W z + V class + b by each bias is the critic's weight
// w. The critic has taken its own step before.
TEST(WganGp, GeneratorFollowsALinearCritic) {
  const LatentTask task = linear_task();
  const auto backend = backend_of(task, always_the_generator);
  backend->set_values(linear_values);
  Stream noise("noise");
  backend->step(0, both, noise);
  const std::vector<float> values = backend->values();
  const std::vector<float> gradient = moments(*backend, "generator");
  ASSERT_EQ(gradient.size(), 12U);  // [3, 1 + 2] weights and 3 biases
  for (std::size_t sample = 0; sample < 3; ++sample) {
    const float weight = values[values.size() - 6 + sample];
    EXPECT_NEAR(gradient[9 + sample], -(1 - wgan_gp_beta1) * weight, 1e-6);
    // The derivative by the weight of each class: half of the windows have that class.
    EXPECT_NEAR(gradient[3 * sample + 1], -(1 - wgan_gp_beta1) * weight / 2, 1e-6);
    EXPECT_NEAR(gradient[3 * sample + 2], -(1 - wgan_gp_beta1) * weight / 2, 1e-6);
  }
}

TEST(WganGp, GeneratorStepsAfterCriticSteps) {
  const LatentTask task = example_task(20, 3, 4);
  const auto backend = backend_of(task, {.critic_steps = 3, .penalty = 10});
  const std::size_t generator_size = nets::total_size(generator_specs(task.generator));
  const auto generator = [&] {
    std::vector<float> values = backend->values();
    values.resize(generator_size);
    return values;
  };
  Stream noise("noise");
  for (std::size_t index = 0; index < 6; ++index) {
    const std::vector<float> before = generator();
    backend->step(index, both, noise);
    EXPECT_EQ(generator() != before, index % 3 == 2) << index;
  }
}

TEST(WganGp, CriticFollowsTheGradientOfItsLosses) {
  const LatentTask task = example_task(20, 3, 4);
  const auto backend = backend_of(task, never_the_generator);
  const std::vector<float> all = backend->values();
  const std::size_t generator_size = nets::total_size(generator_specs(task.generator));
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(generator_size);
  const std::vector<std::size_t> batch{5, 1, 2};
  const auto loss = [&](const std::vector<float>& critic) {
    const auto probe = backend_of(task, never_the_generator);
    std::vector<float> values = all;
    std::ranges::copy(critic, values.begin() + static_cast<std::ptrdiff_t>(generator_size));
    probe->set_values(values);
    Stream noise("noise");
    const std::vector<double> losses = probe->step(0, batch, noise);
    return 10 * losses[1] - losses[0];
  };
  Stream noise("noise");
  backend->step(0, batch, noise);
  std::vector<float> gradient = moments(*backend, "critic");
  for (float& g : gradient) g /= static_cast<float>(1 - wgan_gp_beta1);
  expect_gradient_of(gradient, {begin, all.end()}, loss);
}

}  // namespace
}  // namespace piae::latent
