#include "phase/alignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "phase/class_cycle.hpp"
#include "support/simulated_windows.hpp"

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
    const std::vector<double> rotated = signal::read(std::span<const double>(waveform), start, 61);
    EXPECT_EQ(infer_start(waveform, rotated), start);
  }
}

TEST(Align, FindsTheStartsOfNoisyCopies) {
  const std::vector<double> waveform = noise_of(200, "waveform");
  const std::vector<std::size_t> starts{17, 0, 150, 63};
  std::vector<std::vector<double>> copies;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    copies.push_back(signal::read(std::span<const double>(waveform), starts[i], 200));
    const std::vector<double> noise = noise_of(200, "noise" + std::to_string(i));
    for (std::size_t t = 0; t < 200; ++t) copies.back()[t] += 0.5 * noise[t];
  }
  const Alignment alignment = align(copies);
  const std::size_t origin = starts[alignment.reference];
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_EQ(alignment.starts[i], (starts[i] + 200 - origin) % 200) << i;
  }
}

/// Returns the distance of two angles on the circle.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// Returns the errors of the inferred impact angles of 60 simulated windows, in ascending order, in
/// rad. Stiffness, damping, speed, slip and all angles vary from window to window.
std::vector<double> angle_errors(signal::Defect defect) {
  signal::DatasetInfo info = bearing_info();
  constexpr Label label = 1;
  info.classes[label] = {"021", defect, 0.5334};
  constexpr std::size_t length = 1024;
  const signal::Cycle cycle = cycle_of_class(info, label, length);
  std::vector<std::vector<double>> waveforms;
  std::vector<double> truth;
  for (int i = 0; i < 60; ++i) {
    ImpactWindow window =
        impact_window(info, label, length, Stream("windows").child(std::to_string(i)));
    double mean = 0;
    for (const double x : window.samples) mean += x / length;
    for (double& x : window.samples) x -= mean;
    waveforms.push_back(signal::closed_cycle(window.samples, cycle));
    truth.push_back(window.impact_angle_rad);
  }
  const Alignment alignment = align(waveforms);
  std::vector<double> errors;
  for (std::size_t i = 0; i < waveforms.size(); ++i) {
    if (i == alignment.reference) continue;
    errors.push_back(
        apart(cycle.angle_rad(alignment.starts[i]), truth[i] - truth[alignment.reference]));
  }
  std::ranges::sort(errors);
  return errors;
}

// Tests the alignment on simulated windows, 10 dB above the noise, for each fault type. A random
// angle would have a median error of pi / 2. One sample is 0.056 rad of an outer race's impacts,
// 0.085 of an inner race's, 0.074 of a ball's.
TEST(Align, InfersTheImpactAnglesOfWindowsThatSlipAndDiffer) {
  for (const auto defect : {signal::Defect::outer, signal::Defect::inner, signal::Defect::roller}) {
    const std::vector<double> errors = angle_errors(defect);
    EXPECT_LT(errors[errors.size() / 2], 0.12) << static_cast<int>(defect);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.3) << static_cast<int>(defect);
  }
}

}  // namespace
}  // namespace piae::phase
