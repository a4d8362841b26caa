#include "phase/alignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "phase/cycle.hpp"
#include "simulated.hpp"

namespace piae::phase {
namespace {

std::vector<double> noise_of(std::size_t samples, const std::string& name) {
  Stream stream(name);
  std::vector<double> values(samples);
  for (double& x : values) x = stream.normal(0, 1);
  return values;
}

TEST(InferStart, FindsEveryCircularShiftOfAWaveform) {
  const std::vector<double> waveform = noise_of(61, "waveform");
  for (std::size_t start = 0; start < 61; ++start) {
    const std::vector<double> turned = read(std::span<const double>(waveform), start, 61);
    EXPECT_EQ(infer_start(waveform, turned), start);
  }
}

TEST(Align, FindsTheStartsOfNoisyCopies) {
  const std::vector<double> waveform = noise_of(200, "waveform");
  const std::vector<std::size_t> starts{17, 0, 150, 63};
  std::vector<std::vector<double>> copies;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    copies.push_back(read(std::span<const double>(waveform), starts[i], 200));
    const std::vector<double> noise = noise_of(200, "noise" + std::to_string(i));
    for (std::size_t t = 0; t < 200; ++t) copies.back()[t] += 0.5 * noise[t];
  }
  const Alignment alignment = align(copies);
  const std::size_t origin = starts[alignment.reference];
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_EQ(alignment.starts[i], (starts[i] + 200 - origin) % 200) << i;
  }
}

/// Distance of two angles on the circle.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

// The phase head on simulated windows: 60 windows cut anywhere from a signal whose strikes are
// strictly periodic, with noise 10 dB below; their strike angles against the true ones.
TEST(Align, InfersTheStrikeAngleOfSimulatedWindows) {
  const signal::DatasetInfo info = bearing_info();
  constexpr std::size_t length = 1024;
  const std::vector<double> signal = outer_race_signal(24000, 10, Stream("noise"));
  const Cycle cycle = cycle_of(info, 2, length);
  const double strike_samples = info.sample_rate_hz / strike_frequency_hz(info, 2);
  Stream cuts("cuts");
  std::vector<std::vector<double>> waveforms;
  std::vector<std::size_t> firsts;
  for (int i = 0; i < 60; ++i) {
    firsts.push_back(cuts.below(signal.size() - length));
    std::vector<double> window(
        signal.begin() + static_cast<std::ptrdiff_t>(firsts.back()),
        signal.begin() + static_cast<std::ptrdiff_t>(firsts.back() + length));
    double mean = 0;
    for (const double x : window) mean += x / length;
    for (double& x : window) x -= mean;
    waveforms.push_back(closed_cycle(window, cycle));
  }
  std::vector<double> errors;
  for (std::size_t i = 1; i < waveforms.size(); ++i) {
    const double inferred = cycle.angle_rad(infer_start(waveforms[0], waveforms[i]));
    const double passed = static_cast<double>(firsts[i]) - static_cast<double>(firsts[0]);
    errors.push_back(apart(inferred, 2 * std::numbers::pi * passed / strike_samples));
  }
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.06);       // one sample is 0.056 rad
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.12);  // of 6.28
}

}  // namespace
}  // namespace piae::phase
