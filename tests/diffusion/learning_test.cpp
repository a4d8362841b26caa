#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "diffusion/training.hpp"
#include "support/impact_windows.hpp"

// Our own back end learns a law of windows for each class: a sine of 4 cycles a window for class 1,
// of 11 cycles for class 2, both at any phase. tests/slow/libtorch/diffusion has a joint law of two
// sines, by both back ends.
namespace piae::diffusion {
namespace {

constexpr std::size_t length = 128;
constexpr std::size_t windows_of_class = 40;

int cycles_of(Label label) { return label == 1 ? 4 : 11; }

signal::WindowSet sines(const std::vector<Label>& classes) {
  signal::WindowSet set = no_impact_windows(length);
  Stream stream("sines");
  for (std::size_t i = 0; i < classes.size() * windows_of_class; ++i) {
    const Label label = classes[i % classes.size()];
    const double phase = stream.uniform(0, 2 * std::numbers::pi);
    set.labels.push_back(label);
    for (std::size_t t = 0; t < length; ++t) {
      const double turns = cycles_of(label) * static_cast<double>(t) / length;
      set.samples.push_back(
          static_cast<float>(std::sqrt(2) * std::sin(2 * std::numbers::pi * turns + phase)));
    }
  }
  return set;
}

/// Returns the share of a window's power that a sine of so many cycles has.
double share_of(std::span<const float> window, int cycles) {
  std::complex<double> sum;
  double power = 0;
  for (std::size_t t = 0; t < window.size(); ++t) {
    const double angle = 2 * std::numbers::pi * cycles * static_cast<double>(t) / length;
    sum += static_cast<double>(window[t]) * std::polar(1.0, -angle);
    power += static_cast<double>(window[t]) * window[t];
  }
  return 2 * std::norm(sum) / (static_cast<double>(window.size()) * power);
}

/// Returns the mean share, over generated windows of a class, of the sine of a class.
double mean_share(const DiffusionModel& model, DiffusionBackend& backend, Label made, Label of) {
  constexpr std::size_t count = 8;
  Stream stream("noise");
  std::vector<float> noise(count * length);
  for (float& e : noise) e = static_cast<float>(stream.normal(0, 1));
  const std::vector<float> windows = follow(model, backend, made, noise);
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    mean += share_of(std::span(windows).subspan(i * length, length), cycles_of(of)) / count;
  }
  return mean;
}

/// Trains one network, or a network of "healthy" windows (class 1) and one of what class 2 changes.
void expect_own_sines(Path path, std::size_t networks, Label least) {
  const signal::WindowSet set = sines({1, 2});
  const std::vector<double> rms{1, 1, 1};
  const Course course{.epochs = 2000, .batch = 40, .learning_rate = 4e-3};
  DiffusionModel model{
      .info = set.info,
      .path = path,
      .networks = networks_of(length, 3,
                              std::vector<DenoiserSize>(networks, {.channels = 32, .blocks = 3})),
      .steps = path == Path::flow ? 8 : 30,
      .guidance = 0,
      .rms = rms};
  std::vector<Lesson> lessons;
  if (networks == 2) {
    lessons.push_back(lesson_of(sines({1}), rms, Angle::known, course));
    lessons.push_back(lesson_of(sines({2}), rms, Angle::known, course));
  } else {
    lessons.push_back(lesson_of(set, rms, Angle::known, course));
  }
  DiffusionBackend* backend = nullptr;
  DiffusionTraining training(model, std::move(lessons), 0.1, Stream("toy"),
                             [&](const Networks& all, std::int64_t most, const Stream& initial) {
                               auto made = one_core_diffusion(all, most, initial, Device::cpu);
                               backend = made.get();
                               return made;
                             });
  for (std::size_t epoch = 0; epoch < training.epochs(); ++epoch) training.run_epoch(epoch);
  for (Label label = least; label <= 2; ++label) {
    const Label other = label == 1 ? 2 : 1;
    EXPECT_GT(mean_share(model, *backend, label, label), 0.9) << label;
    EXPECT_LT(mean_share(model, *backend, label, other), 0.02) << label;
  }
}

TEST(LearnedDiffusion, MakesTheSineOfTheClass) { expect_own_sines(Path::diffusion, 1, 1); }

TEST(LearnedFlow, MakesTheSineOfTheClass) { expect_own_sines(Path::flow, 1, 1); }

// The first network has learned the sine of class 1; together they make that of class 2.
TEST(LearnedDiffusion, ChangesHealthyWindowsIntoThoseOfTheFault) {
  expect_own_sines(Path::diffusion, 2, 2);
}

}  // namespace
}  // namespace piae::diffusion
