// Compares whole steps of our diffusion models with LibTorch's, from the same parameters and
// points, and what both learn of a known law.

#include "libtorch/diffusion/backend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "diffusion/example_batch.hpp"
#include "diffusion/training.hpp"
#include "support/gradients.hpp"
#include "support/impact_windows.hpp"

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

/// Two sines of 3 and 7 periods in a window of 64 samples. The first has a uniform phase and the
/// amplitude 1; the second has twice that phase and half the amplitude.
constexpr std::size_t length = 64;
constexpr double amplitudes[] = {1, 0.5};
constexpr int periods[] = {3, 7};

std::vector<float> two_sines(double phase) {
  std::vector<float> window(length);
  for (std::size_t t = 0; t < length; ++t) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(t) / length;
    window[t] = static_cast<float>(amplitudes[0] * std::cos(periods[0] * turn + phase) +
                                   amplitudes[1] * std::cos(periods[1] * turn + 2 * phase));
  }
  return window;
}

/// Distance of windows from that law.
struct Distance {
  double amplitude = 0;  ///< largest relative error of the mean amplitude of a sine
  double coherence = 0;  ///< |mean of exp(i (phase of the second - 2 phase of the first))|; law: 1
  double phase = 0;      ///< |mean of exp(i phase of the first)|; law: 0
  double rest = 0;       ///< share of the energy outside the two sines; law: 0
};

Distance distance_of(const std::vector<float>& windows) {
  const std::size_t n = windows.size() / length;
  std::complex<double> relation = 0;
  std::complex<double> uniform = 0;
  double means[2] = {0, 0};
  double energy = 0;
  double explained = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::complex<double> sines[2];
    for (const std::size_t k : {0U, 1U}) {
      for (std::size_t t = 0; t < length; ++t) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(t) / length;
        sines[k] += 2.0 / length * static_cast<double>(windows[i * length + t]) *
                    std::polar(1.0, -periods[k] * turn);
      }
      means[k] += std::abs(sines[k]) / static_cast<double>(n);
      explained += std::norm(sines[k]) / 2 * length;
    }
    for (std::size_t t = 0; t < length; ++t) {
      energy += std::pow(static_cast<double>(windows[i * length + t]), 2);
    }
    relation +=
        std::polar(1.0, std::arg(sines[1]) - 2 * std::arg(sines[0])) / static_cast<double>(n);
    uniform += std::polar(1.0, std::arg(sines[0])) / static_cast<double>(n);
  }
  return {.amplitude = std::max(std::abs(means[0] / amplitudes[0] - 1),
                                std::abs(means[1] / amplitudes[1] - 1)),
          .coherence = std::abs(relation),
          .phase = std::abs(uniform),
          .rest = 1 - explained / energy};
}

std::vector<float> learned_by(Path path, MakeDiffusionBackend make) {
  constexpr std::size_t windows = 512;
  DiffusionModel model{.info = three_classes(),
                       .path = path,
                       .networks = networks_of(length, 3, {{.channels = 32, .blocks = 3}}),
                       .steps = path == Path::flow ? 8 : 50,
                       .guidance = 0,
                       .rms = {1, 1, 1}};
  Lesson lesson{.windows = {},
                .labels = std::vector<Label>(windows, 1),
                .cycles = {},
                .course = {.epochs = 500, .batch = 32, .learning_rate = 3e-3}};
  Stream phases("phases");
  for (std::size_t i = 0; i < windows; ++i) {
    const std::vector<float> window = two_sines(phases.uniform(0, 2 * std::numbers::pi));
    lesson.windows.insert(lesson.windows.end(), window.begin(), window.end());
  }
  DiffusionBackend* trained = nullptr;
  DiffusionTraining training(
      model, {lesson}, 0, Stream("toy"),
      [&](const Networks& networks, std::int64_t /*most*/, const Stream& initial) {
        auto made = make(networks, windows, initial, Device::cpu);
        trained = made.get();
        return made;
      });
  for (std::size_t epoch = 0; epoch < training.epochs(); ++epoch) training.run_epoch(epoch);
  std::vector<float> noise(windows * length);
  Stream stream("noise");
  for (float& e : noise) e = static_cast<float>(stream.normal(0, 1));
  return follow(model, *trained, 1, noise);
}

// With 512 windows of noise |mean of exp(i phase)| is below 0.12 with 99.9 % for a uniform phase.
void expect_the_law(const Distance& distance) {
  EXPECT_LT(distance.amplitude, 0.15);
  EXPECT_GT(distance.coherence, 0.95);
  EXPECT_LT(distance.phase, 0.15);
  EXPECT_LT(distance.rest, 0.02);
}

TEST(TwoSines, AreTheirOwnLaw) {
  std::vector<float> windows;
  for (int i = 0; i < 512; ++i) {
    const auto window = two_sines(2 * std::numbers::pi * i / 512);
    windows.insert(windows.end(), window.begin(), window.end());
  }
  const Distance distance = distance_of(windows);
  EXPECT_LT(distance.amplitude, 1e-5);
  EXPECT_GT(distance.coherence, 1 - 1e-5);
  EXPECT_LT(distance.phase, 1e-5);
  EXPECT_LT(distance.rest, 1e-5);
}

TEST(TwoSines, AreLearnedByBothBackEnds) {
  for (const Path path : {Path::diffusion, Path::flow}) {
    for (const MakeDiffusionBackend make : {one_core_diffusion, libtorch::diffusion_backend}) {
      SCOPED_TRACE(path == Path::flow ? "flow" : "diffusion");
      SCOPED_TRACE(make == one_core_diffusion ? "our own" : "LibTorch's");
      const Distance distance = distance_of(learned_by(path, make));
      std::cout << "amplitude " << distance.amplitude << ", coherence " << distance.coherence
                << ", phase " << distance.phase << ", rest " << distance.rest << '\n';
      expect_the_law(distance);
    }
  }
}

}  // namespace
}  // namespace piae::diffusion
