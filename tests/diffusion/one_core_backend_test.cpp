#include <gtest/gtest.h>

#include <cmath>

#include "diffusion/example_batch.hpp"
#include "diffusion/model.hpp"
#include "support/gradients.hpp"

namespace piae::diffusion {
namespace {

std::unique_ptr<DiffusionBackend> one_core(const Networks& networks) {
  return one_core_diffusion(networks, 8, Stream("initial"), Device::cpu);
}

Networks example_networks(std::size_t count) {
  return networks_of(64, 3, std::vector<DenoiserSize>(count, {.channels = 16, .blocks = 2}));
}

std::size_t size_of(const Denoiser& network) { return nets::total_size(denoiser_specs(network)); }

TEST(OneCoreDiffusion, ReturnsTheMeanSquaredError) {
  const auto backend = one_core(example_networks(1));
  const NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> wanted = example_velocities(batch);
  const std::vector<float> estimated = backend->velocities(batch, 1);
  double mean = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    mean += std::pow(static_cast<double>(estimated[i]) - wanted[i], 2) /
            static_cast<double>(wanted.size());
  }
  EXPECT_NEAR(backend->step(0, batch, wanted, 1e-3), mean, 1e-5 * mean);
}

// Initial values depend on the name of a network alone.
TEST(OneCoreDiffusion, AddsTheVelocitiesOfItsNetworks) {
  const Networks networks = example_networks(2);
  const NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> first = one_core({networks[0]})->velocities(batch, 1);
  const std::vector<float> second = one_core({networks[1]})->velocities(batch, 1);
  const auto both = one_core(networks);
  EXPECT_EQ(both->velocities(batch, 1), first);
  const std::vector<float> sum = both->velocities(batch, 2);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_FLOAT_EQ(sum[i], first[i] + second[i]) << i;
  }
}

TEST(OneCoreDiffusion, ShowsTheClassToTheLastNetworkOnly) {
  const auto backend = one_core(example_networks(2));
  NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> healthy = backend->velocities(batch, 1);
  const std::vector<float> both = backend->velocities(batch, 2);
  batch.labels = {2, 0, 1};
  EXPECT_EQ(backend->velocities(batch, 1), healthy);
  EXPECT_NE(backend->velocities(batch, 2), both);
}

TEST(OneCoreDiffusion, TrainsOnlyTheGivenNetwork) {
  const Networks networks = example_networks(2);
  const auto backend = one_core(networks);
  const NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> before = backend->values();
  backend->step(1, batch, example_velocities(batch), 1e-3);
  const std::vector<float> after = backend->values();
  const auto first = static_cast<std::ptrdiff_t>(size_of(networks[0]));
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + first, after.begin()));
  EXPECT_FALSE(std::equal(before.begin() + first, before.end(), after.begin() + first));
}

// The gradient is that of finite differences, limited to a norm of 1.
TEST(OneCoreDiffusion, FollowsTheGradientOfTheError) {
  const Networks networks = example_networks(2);
  const NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> wanted = example_velocities(batch);
  for (const std::size_t trained : {0U, 1U}) {
    const auto backend = one_core(networks);
    const std::vector<float> start = backend->values();
    const auto begin = static_cast<std::ptrdiff_t>(trained == 0 ? 0 : size_of(networks[0]));
    const auto size = static_cast<std::ptrdiff_t>(size_of(networks[trained]));
    const auto part = [&](const std::vector<float>& all) {
      return std::vector<float>(all.begin() + begin, all.begin() + begin + size);
    };
    const auto loss = [&](const std::vector<float>& values) {
      const auto probe = one_core(networks);
      std::vector<float> all = start;
      std::ranges::copy(values, all.begin() + begin);
      probe->set_values(all);
      return probe->step(trained, batch, wanted, 1e-3);
    };
    backend->step(trained, batch, wanted, 1e-3);
    std::vector<float> gradient =
        first_moments([&](artefact::Writer& writer) { backend->write_adam(writer); },
                      "/adam/" + networks[trained].name);
    for (float& g : gradient) g *= 10;  // 1 - beta1 = 0.1
    double norm = 0;
    for (const float g : gradient) norm += static_cast<double>(g) * g;
    ASSERT_LT(norm, 1 - 1e-4) << "is limited: the test needs a smaller error";
    expect_gradient_of(gradient, part(start), loss);
  }
}

TEST(OneCoreDiffusion, DoesNotLetWindowsOfABatchInteract) {
  const auto backend = one_core(example_networks(1));
  const NoisyBatch batch = example_batch(64, 3);
  const std::vector<float> together = backend->velocities(batch, 1);
  for (std::size_t i = 0; i < batch.u.size(); ++i) {
    const auto first = batch.windows.begin() + static_cast<std::ptrdiff_t>(64 * i);
    const NoisyBatch alone{
        .windows = {first, first + 64}, .u = {batch.u[i]}, .labels = {batch.labels[i]}};
    const std::vector<float> velocity = backend->velocities(alone, 1);
    EXPECT_TRUE(std::ranges::equal(velocity, std::span(together).subspan(64 * i, 64))) << i;
  }
}

}  // namespace
}  // namespace piae::diffusion
