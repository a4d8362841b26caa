// The VAE for one core: losses of a hand-worked network, and gradients by finite differences.

#include "latent/vae.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "latent/example_task.hpp"
#include "support/gradients.hpp"

namespace piae::latent {
namespace {

std::unique_ptr<LatentBackend> backend_of(const LatentTask& task) {
  return vae(task, Stream("initial"), Device::cpu);
}

double loss_of(const std::vector<double>& losses) { return losses.at(0) + losses.at(1); }

TEST(Vae, HasTheHandWorkedLosses) {
  // One sample, one class, one latent number, single layers: x = 2, q = N(0.5 x, 1), so z = 1 +
  // noise; decoded 0.25 z + 1. KL(N(m, 1) || N(0, 1)) = m^2 / 2.
  LatentTask task = example_task(1, 1, 1);
  task.generator.size.depth = 1;
  task.windows = {2};
  task.labels = {0};
  const auto backend = backend_of(task);
  // Generator: weights of z and class, bias; encoder: weights of mean and log variance by x and
  // class, their biases.
  backend->set_values(std::vector<float>{0.25F, 0, 1, 0.5F, 0, 0, 0, 0, 0});
  Stream noise("noise");
  Stream same("noise");
  const double z = 1 + normal_numbers(same, 1).front();
  const std::size_t only[] = {0};
  const std::vector<double> losses = backend->step(0, only, noise);
  EXPECT_NEAR(losses[0], 0.5 * std::pow(0.25 * z + 1 - 2, 2), 1e-6);
  EXPECT_NEAR(losses[1], 0.5, 1e-6);
}

// KL(N(m, s^2) || N(0, 1)) = (m^2 + s^2 - 1) / 2 - log s
TEST(Vae, SumsTheClosedFormDivergenceAndAveragesOverWindows) {
  LatentTask task = example_task(1, 1, 2);
  task.generator.size.depth = 1;
  task.windows = {1, -1};
  task.labels = {0, 0};
  const auto backend = backend_of(task);
  const float log_variance = 2 * std::log(0.4F);
  // The outputs are mean 0, mean 1, log variance 0 and log variance 1; only mean 0 depends on x.
  backend->set_values(
      std::vector<float>{0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0.7F, log_variance, 0});
  Stream noise("noise");
  const std::size_t both[] = {0, 1};
  const double of_first = (9 + 0.16 - 1) / 2 - std::log(0.4);
  const double of_second = 0.49 / 2;
  EXPECT_NEAR(backend->step(0, both, noise)[1], of_first + of_second, 1e-5);
}

TEST(Vae, FollowsTheGradientOfItsLosses) {
  const LatentTask task = example_task(20, 3, 4);
  const auto backend = backend_of(task);
  const std::vector<float> start = backend->values();
  const std::vector<std::size_t> batch{5, 1, 2};
  const auto loss = [&](const std::vector<float>& values) {
    const auto probe = backend_of(task);
    probe->set_values(values);
    Stream noise("noise");
    return loss_of(probe->step(0, batch, noise));
  };
  Stream noise("noise");
  backend->step(0, batch, noise);
  std::vector<float> gradient = first_moments(
      [&](artefact::Writer& writer) { backend->write_adam(writer); }, "/adam/networks");
  for (float& g : gradient) g *= 10;  // 1 - beta1 = 0.1
  expect_gradient_of(gradient, start, loss);
}

}  // namespace
}  // namespace piae::latent
