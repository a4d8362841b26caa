// Each diffusion and flow model learns a known joint law of each of two classes, by our back end,
// by LibTorch's, and by a second implementation (plain_diffusion.hpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iostream>
#include <numbers>

#include "diffusion/training.hpp"
#include "libtorch/diffusion/backend.hpp"
#include "slow/libtorch/diffusion/plain_diffusion.hpp"
#include "support/three_classes.hpp"

namespace piae::diffusion {
namespace {

// The law: two sines of 3 and 6 periods a window. The first has a uniform phase and the amplitude
// 1, the second twice that phase, more by an angle of the class, and half the amplitude. So a
// window that is read from another start obeys the same law.
constexpr std::size_t length = 64;
constexpr std::size_t count = 512;
constexpr double amplitudes[] = {1, 0.5};
constexpr int periods[] = {3, 6};
double angle_of(Label label) { return label * std::numbers::pi / 2; }

std::vector<float> two_sines(Label label, double phase) {
  std::vector<float> window(length);
  for (std::size_t t = 0; t < length; ++t) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(t) / length;
    window[t] = static_cast<float>(amplitudes[0] * std::cos(periods[0] * turn + phase) +
                                   amplitudes[1] *
                                       std::cos(periods[1] * turn + 2 * phase + angle_of(label)));
  }
  return window;
}

/// Distance of windows from that law.
struct Distance {
  double amplitude = 0;  ///< largest relative error of the mean amplitude of a sine
  double relation =
      0;             ///< |1 - mean of exp(i (phase of the second - 2 phase of the first - angle))|
  double phase = 0;  ///< |mean of exp(i phase of the first)|; law: 0
  double rest = 0;   ///< share of the energy outside the two sines
};

Distance distance_of(const std::vector<float>& windows, Label label) {
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
    relation += std::polar(1.0, std::arg(sines[1]) - 2 * std::arg(sines[0]) - angle_of(label)) /
                static_cast<double>(n);
    uniform += std::polar(1.0, std::arg(sines[0])) / static_cast<double>(n);
  }
  return {.amplitude = std::max(std::abs(means[0] / amplitudes[0] - 1),
                                std::abs(means[1] / amplitudes[1] - 1)),
          .relation = std::abs(1.0 - relation),
          .phase = std::abs(uniform),
          .rest = 1 - explained / energy};
}

// With 512 windows |mean of exp(i phase)| is below 0.12 with 99.9 % for a uniform phase.
void expect_the_law(const std::vector<float>& windows, Label label) {
  const Distance distance = distance_of(windows, label);
  std::cout << "class " << label << ": amplitude " << distance.amplitude << ", relation "
            << distance.relation << ", phase " << distance.phase << ", rest " << distance.rest
            << '\n';
  EXPECT_LT(distance.amplitude, 0.15);
  EXPECT_LT(distance.relation, 0.1);
  EXPECT_LT(distance.phase, 0.15);
  EXPECT_LT(distance.rest, 0.02);
}

struct Windows {
  std::vector<float> samples;  ///< [n, N]
  std::vector<Label> labels;   ///< [n]
};

/// Returns windows of these classes in turn. Each class has so many different phases.
Windows drawn_windows(const std::vector<Label>& classes, std::size_t phases) {
  Windows drawn;
  for (std::size_t i = 0; i < count; ++i) {
    const Label label = classes[i % classes.size()];
    Stream stream("phase" + std::to_string(i / classes.size() % phases));
    const std::vector<float> window = two_sines(label, stream.uniform(0, 2 * std::numbers::pi));
    drawn.samples.insert(drawn.samples.end(), window.begin(), window.end());
    drawn.labels.push_back(label);
  }
  return drawn;
}

std::vector<float> normal_noise() {
  std::vector<float> noise(count * length);
  Stream stream("noise");
  for (float& e : noise) e = static_cast<float>(stream.normal(0, 1));
  return noise;
}

Lesson lesson_in(const std::vector<Label>& classes, Angle angle) {
  // With the angle drawn, five windows of each class teach the law of all phases.
  const Windows known = drawn_windows(classes, angle == Angle::drawn ? 5 : count);
  Lesson lesson{.windows = known.samples,
                .labels = known.labels,
                .cycles = {},
                .course = {.epochs = 500, .batch = 32, .learning_rate = 3e-3}};
  for (std::size_t i = 0; angle == Angle::drawn && i < count; ++i) {
    const auto first = known.samples.begin() + static_cast<std::ptrdiff_t>(i * length);
    lesson.cycles.emplace_back(first, first + length);
  }
  return lesson;
}

void expect_learned(Path path, Angle angle, std::size_t networks, MakeDiffusionBackend make) {
  const DenoiserSize size{.channels = 32, .blocks = 3};
  const DiffusionModel model{.info = three_classes(),
                             .path = path,
                             .networks = networks_of(length, 3, std::vector(networks, size)),
                             .steps = path == Path::flow ? 8 : 50,
                             .guidance = 0,
                             .rms = {1, 1, 1}};
  std::vector<Lesson> lessons;
  if (networks == 2) lessons.push_back(lesson_in({0}, Angle::known));  // healthy
  lessons.push_back(lesson_in({1, 2}, angle));
  DiffusionBackend* trained = nullptr;
  DiffusionTraining training(model, lessons, 0.1, Stream("toy"),
                             [&](const Networks& all, std::int64_t most, const Stream& initial) {
                               auto made = make(all, std::max<std::int64_t>(most, count), initial,
                                                Device::cpu);
                               trained = made.get();
                               return made;
                             });
  for (std::size_t epoch = 0; epoch < training.epochs(); ++epoch) training.run_epoch(epoch);
  for (const Label label : {1, 2}) {
    expect_the_law(follow(model, *trained, label, normal_noise()), label);
  }
}

TEST(JointLaw, IsThatOfItsOwnWindows) {
  const Windows drawn = drawn_windows({1}, count);
  const Distance own = distance_of(drawn.samples, 1);
  EXPECT_LT(own.amplitude, 1e-5);
  EXPECT_LT(own.relation, 1e-5);
  EXPECT_LT(own.rest, 1e-5);
  EXPECT_LT(own.phase, 0.15);
  EXPECT_NEAR(distance_of(drawn.samples, 2).relation, std::numbers::sqrt2, 1e-5);
}

TEST(JointLaw, IsLearnedByDdpm) {
  expect_learned(Path::diffusion, Angle::known, 1, one_core_diffusion);
  expect_learned(Path::diffusion, Angle::known, 1, libtorch::diffusion_backend);
}

TEST(JointLaw, IsLearnedByFlow) {
  expect_learned(Path::flow, Angle::known, 1, one_core_diffusion);
  expect_learned(Path::flow, Angle::known, 1, libtorch::diffusion_backend);
}

TEST(JointLaw, IsLearnedByDdpmHealthy) {
  expect_learned(Path::diffusion, Angle::known, 2, one_core_diffusion);
}

TEST(JointLaw, IsLearnedFromFiveWindowsWithTheAngle) {
  expect_learned(Path::diffusion, Angle::drawn, 1, one_core_diffusion);
  expect_learned(Path::diffusion, Angle::drawn, 2, one_core_diffusion);
  expect_learned(Path::flow, Angle::drawn, 1, one_core_diffusion);
}

TEST(JointLaw, IsLearnedByASecondImplementation) {
  torch::set_num_threads(1);
  torch::manual_seed(1);
  Windows known = drawn_windows({1, 2}, count);
  const torch::Tensor windows =
      torch::from_blob(known.samples.data(), {count, length}, torch::kFloat).clone();
  const torch::Tensor labels =
      torch::tensor(std::vector<std::int64_t>(known.labels.begin(), known.labels.end()));
  const auto samples_of = [](const torch::Tensor& made) {
    const torch::Tensor flat = made.contiguous();
    return std::vector<float>(flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
  };
  const torch::Tensor noise = torch::randn({count, length});
  plain::Network diffusion(length, 3);
  plain::train_diffusion(diffusion, windows, labels, 8000);
  plain::Network flow(length, 3);
  plain::train_flow(flow, windows, labels, 8000);
  for (const Label label : {1, 2}) {
    expect_the_law(samples_of(plain::sample_diffusion(diffusion, noise, label, 50)), label);
    expect_the_law(samples_of(plain::sample_flow(flow, noise, label, 32)), label);
  }
}

}  // namespace
}  // namespace piae::diffusion
