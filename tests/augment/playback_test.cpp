#include "augment/playback.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "augment/methods.hpp"

namespace piae::augment {
namespace {

constexpr std::size_t played_length = 1024;

/// Returns a tone of 100 periods in each of the two fault classes, known at 1200 rpm and tested at
/// 900.
signal::WindowSet tones() {
  signal::WindowSet known;
  known.info = known_windows().info;
  known.info.conditions = {
      {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = false, .healthy = true},
      {.name = "slow", .shaft_speed_rpm = 900, .known = false, .test = true, .healthy = true}};
  known.length = played_length;
  for (const Label label : {1, 2}) {
    for (std::size_t t = 0; t < played_length; ++t) {
      known.samples.push_back(static_cast<float>(
          std::sin(2 * std::numbers::pi * 100 * static_cast<double>(t) / double{played_length})));
    }
    known.labels.push_back(label);
    known.condition.push_back(0);
    known.shaft_speed_rpm.push_back(1200);
  }
  return known;
}

/// Returns the periods in a window: half its sign changes.
double periods(std::span<const float> window) {
  int changes = 0;
  for (std::size_t t = 1; t < window.size(); ++t) changes += window[t - 1] * window[t] < 0 ? 1 : 0;
  return changes / 2.0;
}

TEST(Resample, PlaysTheKnownWindowsAtTheTestedSpeed) {
  const auto model = train("resample", "", tones(), checkpoint_at("checkpoint"), "model.h5");
  const signal::WindowSet windows = generate("resample", model, 4);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    EXPECT_NEAR(periods(windows.window(i)), 75, 1) << i;
    EXPECT_EQ(windows.condition[i], 1) << i;
    EXPECT_EQ(windows.shaft_speed_rpm[i], 900) << i;
  }
}

TEST(Playback, RecordsWhichWindowItPlays) {
  for (const std::string name : {"resample", "randomise"}) {
    const auto model = train(name, "", tones(), checkpoint_at("checkpoint"), "model.h5");
    EXPECT_EQ(generate(name, model, 2).parents, (std::vector<signal::Parents>{{0}, {0}, {1}, {1}}));
  }
}

TEST(Randomise, PlaysKnownWindowsAtSpeedsBetween) {
  const auto model = train("randomise", "", tones(), checkpoint_at("checkpoint"), "model.h5");
  const signal::WindowSet windows = generate("randomise", model, 200);
  double sum = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double own = periods(windows.window(i));
    EXPECT_GT(own, 73) << i;
    EXPECT_LT(own, 102) << i;
    sum += own;
  }
  // Uniform in the logarithm, from 75 to 100: the mean is 25 / log(4 / 3) = 86.9, with a standard
  // deviation of 7.2 / sqrt(400) = 0.36.
  EXPECT_NEAR(sum / static_cast<double>(windows.size()), 86.9, 1.3);
}

TEST(Randomise, GivesEachWindowItsOwnPath) {
  signal::WindowSet known = tones();
  for (std::size_t t = 0; t < known.samples.size(); ++t) {
    known.samples[t] += static_cast<float>(
        std::sin(2 * std::numbers::pi * 400 * static_cast<double>(t) / double{played_length}));
  }
  const auto spread_of = [&](const std::string& options) {
    const auto model = train("randomise", options, known, checkpoint_at("checkpoint"), "model.h5");
    const signal::WindowSet windows = generate("randomise", model, 60);
    double sum = 0;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      // Steepness over level measures the strength of the upper tone relative to the lower.
      double steps = 0;
      double level = 0;
      const auto window = windows.window(i);
      for (std::size_t t = 1; t < window.size(); ++t) {
        steps += std::pow(window[t] - window[t - 1], 2);
        level += std::pow(window[t], 2);
      }
      sum += std::pow(std::log(steps / level), 2);
    }
    return sum;
  };
  EXPECT_GT(spread_of("--equaliser-db 12"), 1.2 * spread_of("--equaliser-db 0"));
}

/// Returns `turns` periods of a sine, which ends where it begins.
std::vector<float> sine_of(int turns, std::size_t length) {
  std::vector<float> window(length);
  for (std::size_t t = 0; t < length; ++t) {
    window[t] = static_cast<float>(std::sin(2 * std::numbers::pi * turns * static_cast<double>(t) /
                                            static_cast<double>(length)));
  }
  return window;
}

/// Returns the best fitting sine of `radians_per_sample` as a phasor: sin is 1, cos is i.
std::complex<double> phasor(const std::vector<double>& samples, double radians_per_sample) {
  std::complex<double> sum;
  for (std::size_t t = 0; t < samples.size(); ++t) {
    const double angle = radians_per_sample * static_cast<double>(t);
    sum += samples[t] * std::complex<double>(std::sin(angle), std::cos(angle));
  }
  return 2.0 * sum / static_cast<double>(samples.size());
}

TEST(Playback, PlaysASineAtAnotherPitchFromTheRequestedSample) {
  constexpr std::size_t length = 1024;
  constexpr std::size_t start = 300;
  for (const double factor : {0.5, 0.75, 0.8342, 1.0, 1.5, 2.0}) {
    const std::vector<double> fast = played(sine_of(64, length), start, factor);
    ASSERT_EQ(fast.size(), length) << factor;
    const double pitch = 2 * std::numbers::pi * 64 / length;
    const std::complex<double> found = phasor(fast, pitch * factor);
    EXPECT_NEAR(std::abs(found), 1, 0.01) << factor;
    // A period is 16 samples long.
    const double samples = std::remainder(std::arg(found) / pitch - start, 16);
    EXPECT_GT(samples, -1.01) << factor;
    EXPECT_LT(samples, 0.01) << factor;
  }
}

TEST(Playback, IsTheWindowShiftedAtItsOwnSpeed) {
  const std::vector<float> window{1, 2, 3, 4};
  EXPECT_EQ(played(window, 3, 1), (std::vector<double>{4, 1, 2, 3}));
}

TEST(Playback, DoesNotAlias) {
  constexpr std::size_t length = 1024;
  const std::vector<double> fast = played(sine_of(400, length), 0, 1.5);  // 1.17 times Nyquist's
  for (const double x : fast) EXPECT_NEAR(x, 0, 0.02);
}

}  // namespace
}  // namespace piae::augment
