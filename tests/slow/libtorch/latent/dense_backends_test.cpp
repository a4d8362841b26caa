// Compares whole steps of our VAE and WGAN-GP with LibTorch's, from the same parameters and noise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/random.hpp"
#include "latent/example_task.hpp"
#include "latent/vae.hpp"
#include "latent/wgan_gp.hpp"
#include "libtorch/latent/backends.hpp"
#include "support/gradients.hpp"

namespace piae::latent {
namespace {

using Make = std::function<std::unique_ptr<LatentBackend>(const LatentTask&)>;

struct Case {
  const char* name;
  Make native;
  Make libtorch;
  std::vector<std::string> adams;
};

std::vector<float> first_moments(const LatentBackend& backend, const std::string& adam) {
  return piae::first_moments([&](artefact::Writer& writer) { backend.write_adam(writer); },
                             "/adam/" + adam);
}

class DenseLatentsAgainstLibtorch : public testing::TestWithParam<Case> {};

// Adam's moments are sums of gradients. The last batch is smaller than the others.
TEST_P(DenseLatentsAgainstLibtorch, StepLikeLibtorch) {
  const LatentTask task = example_task(50, 3, 7, 24);
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
    EXPECT_LT(relative_difference(mine->values(), theirs->values()), 1e-4) << i;
  }
  for (const std::string& adam : GetParam().adams) {
    const std::vector<float> expected = first_moments(*theirs, adam);
    EXPECT_TRUE(std::ranges::any_of(expected, [](float x) { return x != 0; })) << adam;
    EXPECT_LT(relative_difference(first_moments(*mine, adam), expected), 1e-4) << adam;
  }
  EXPECT_EQ(my_noise.uniform(0, 1), their_noise.uniform(0, 1));  // same number of draws
}

const WganGpOptions two_critic_steps{.critic_steps = 2};

INSTANTIATE_TEST_SUITE_P(
    Latent, DenseLatentsAgainstLibtorch,
    testing::Values(
        Case{"Vae",
             [](const LatentTask& task) { return latent::vae(task, Stream("i"), Device::cpu); },
             [](const LatentTask& task) { return libtorch::vae(task, Stream("i"), Device::cpu); },
             {"networks"}},
        Case{"WganGp",
             [](const LatentTask& task) {
               return latent::wgan_gp(task, two_critic_steps, Stream("i"), Device::cpu);
             },
             [](const LatentTask& task) {
               return libtorch::wgan_gp(task, two_critic_steps, Stream("i"), Device::cpu);
             },
             {"critic", "generator"}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace piae::latent
