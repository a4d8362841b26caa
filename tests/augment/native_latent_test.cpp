// Whole steps of our VAE and WGAN-GP against LibTorch's, from the same parameters and noise.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "augment/vae_backends.hpp"
#include "augment/wgan_gp_backends.hpp"
#include "base/random.hpp"

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
  artefact::Writer writer("model");
  backend.write_adam(writer);
  const auto path = std::filesystem::path(testing::TempDir()) / "native_latent_adam.h5";
  writer.save(path, {});
  return artefact::Reader(path, "model")
      .numbers<float>("/adam/" + adam + "/first_moment", {0})
      .values;
}

/// |a - b| / |b|
double difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0;
  double size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    squares += std::pow(static_cast<double>(a.at(i)) - b[i], 2);
    size += std::pow(static_cast<double>(b[i]), 2);
  }
  return std::sqrt(squares / size);
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
    EXPECT_LT(difference(mine->values(), theirs->values()), 1e-4) << i;
  }
  for (const std::string& adam : GetParam().adams) {
    EXPECT_LT(difference(first_moments(*mine, adam), first_moments(*theirs, adam)), 1e-4) << adam;
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
