// Compares whole steps of our diffusion models with LibTorch's, from the same parameters and
// points.

#include "libtorch/diffusion/backend.hpp"

#include <gtest/gtest.h>

#include "diffusion/example_batch.hpp"
#include "diffusion/model.hpp"
#include "support/gradients.hpp"

namespace piae::diffusion {
namespace {

Networks two_networks() {
  return networks_of(64, 3, {{.channels = 32, .blocks = 3}, {.channels = 16, .blocks = 2}});
}

TEST(DiffusionAgainstLibtorch, StepsAlike) {
  const Networks networks = two_networks();
  const auto mine = one_core_diffusion(networks, 4, Stream("i"), Device::cpu);
  const auto theirs = libtorch::diffusion_backend(networks, 4, Stream("i"), Device::cpu);
  ASSERT_EQ(mine->values(), theirs->values());
  const NoisyBatch batch = example_batch(64, 4);
  const std::vector<float> wanted = example_velocities(batch);
  for (std::size_t step = 0; step < 4; ++step) {
    const std::size_t trained = step / 2;
    EXPECT_LT(relative_difference(mine->velocities(batch, trained + 1),
                                  theirs->velocities(batch, trained + 1)),
              1e-5);
    const double expected = theirs->step(trained, batch, wanted, 1e-3);
    EXPECT_NEAR(mine->step(trained, batch, wanted, 1e-3), expected, 1e-5 * expected);
    EXPECT_LT(relative_difference(mine->values(), theirs->values()), 1e-4) << step;
  }
  for (const Denoiser& network : networks) {
    const auto moments = [&](const DiffusionBackend& backend) {
      return first_moments([&](artefact::Writer& writer) { backend.write_adam(writer); },
                           "/adam/" + network.name);
    };
    EXPECT_LT(relative_difference(moments(*mine), moments(*theirs)), 1e-4) << network.name;
  }
}

}  // namespace
}  // namespace piae::diffusion
