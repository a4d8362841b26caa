// Whole steps of our VAE and WGAN-GP against LibTorch's, from the same parameters and noise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "latent/vae.hpp"
#include "latent/wgan_gp.hpp"
#include "base/random.hpp"
#include "nets/steps.hpp"

namespace piae::augment {
namespace {

LatentTask example_task() {
  LatentTask task;
  task.generator.info.classes.resize(3);
  task.generator.samples = 50;
  task.generator.latent = 7;
  task.generator.size = {3, 24};
  task.options = {
      .epochs = 1, .batch = 4, .learning_rate = 1e-3, .latent = 7, .depth = 3, .width = 24};
  Stream stream("windows");
  for (std::int32_t i = 0; i < 6; ++i) {
    task.labels.push_back(i % 3);
    for (std::int64_t t = 0; t < task.generator.samples; ++t) {
      task.windows.push_back(static_cast<float>(stream.normal(0, 1)));
    }
  }
  return task;
}

using Make = std::function<std::unique_ptr<LatentBackend>(const LatentTask&)>;

struct Case {
  const char* name;
  Make native;
  Make libtorch;
  std::vector<std::string> adams;
};

std::vector<float> first_moments(const LatentBackend& backend, const std::string& adam) {
  return nets::first_moments([&](artefact::Writer& writer) { backend.write_adam(writer); },
                             "/adam/" + adam);
}

class NativeLatents : public testing::TestWithParam<Case> {};

// Moments are sums of gradients. The last batch is smaller than the others.
TEST_P(NativeLatents, StepAsLibtorchDoes) {
  const LatentTask task = example_task();
  const auto mine = GetParam().native(task);
  const auto theirs = GetParam().libtorch(task);
  ASSERT_EQ(mine->values(), theirs->values());
  Stream my_noise("noise");
  Stream their_noise("noise");
  const std::vector<std::vector<std::size_t>> batches{{5, 1, 2, 0}, {3, 4}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<double> own = mine->step(i, batches[i % 2], my_noise);
    const std::vector<double> other = theirs->step(i, batches[i % 2], their_noise);
    ASSERT_EQ(own.size(), other.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      EXPECT_NEAR(own[k], other[k], 1e-5 * (1 + std::abs(other[k]))) << i;
    }
    EXPECT_LT(nets::difference(mine->values(), theirs->values()), 1e-4) << i;
  }
  for (const std::string& adam : GetParam().adams) {
    const std::vector<float> expected = first_moments(*theirs, adam);
    EXPECT_TRUE(std::ranges::any_of(expected, [](float x) { return x != 0; })) << adam;
    EXPECT_LT(nets::difference(first_moments(*mine, adam), expected), 1e-4) << adam;
  }
  EXPECT_EQ(my_noise.uniform(0, 1), their_noise.uniform(0, 1));  // as much was drawn
}

const WganGpOptions two_critic_steps{.critic_steps = 2};

INSTANTIATE_TEST_SUITE_P(
    Augment, NativeLatents,
    testing::Values(
        Case{"Vae",
             [](const LatentTask& task) { return native_vae(task, Stream("i"), "cpu"); },
             [](const LatentTask& task) { return libtorch_vae(task, Stream("i"), "cpu"); },
             {"networks"}},
        Case{"WganGp",
             [](const LatentTask& task) {
               return native_wgan_gp(task, two_critic_steps, Stream("i"), "cpu");
             },
             [](const LatentTask& task) {
               return libtorch_wgan_gp(task, two_critic_steps, Stream("i"), "cpu");
             },
             {"critic", "generator"}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace piae::augment
