#include "augment/dynamics.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "augment/methods.hpp"
#include "bearing/kinematics.hpp"
#include "signal/amplitude.hpp"
#include "support/envelope_spectrum.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

/// Returns two windows of each fault; only their RMS matters.
signal::WindowSet three_faults(std::size_t length) {
  signal::WindowSet windows;
  windows.info.name = "example";
  windows.info.sample_rate_hz = 12000;
  windows.info.shaft_speed_rpm = 1797;
  windows.info.unit_m_per_s2 = 9.80665;
  windows.info.classes = {{"Normal", signal::Defect::none, 0},
                          {"IR", signal::Defect::inner, 0.5334},
                          {"B", signal::Defect::roller, 0.5334},
                          {"OR", signal::Defect::outer, 0.5334}};
  windows.length = length;
  Stream stream("three faults");
  for (int label = 1; label <= 3; ++label) {
    for (int i = 0; i < 2; ++i) {
      for (std::size_t t = 0; t < length; ++t) {
        windows.samples.push_back(static_cast<float>(stream.normal(0.3, label)));
      }
      windows.labels.push_back(label);
    }
  }
  return windows;
}

std::filesystem::path model(const signal::WindowSet& known, const std::string& options = "") {
  return train("dynamics", options, known, checkpoint_at("checkpoint"), "model.h5");
}

TEST(Dynamics, WindowsHaveZeroMeanAndTheRmsOfTheirClass) {
  const signal::WindowSet known = three_faults(512);
  const signal::WindowSet windows = generate("dynamics", model(known), 3);
  const std::vector<double> expected = signal::rms_by_class(known);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    double sum = 0;
    double squares = 0;
    for (const double x : windows.window(i)) {
      sum += x;
      squares += x * x;
    }
    EXPECT_NEAR(sum / 512, 0, 1e-6);
    EXPECT_NEAR(std::sqrt(squares / 512) / expected[windows.labels[i]], 1, 1e-6);
  }
}

/// A class's line and the distance half way to its side lines, in Hz.
struct Line {
  double hz, reach_hz;
};

std::vector<Line> lines(double slip) {
  const bearing::FaultFrequencies f = bearing::fault_frequencies({}, 1797, slip);
  return {
      {}, {f.bpfi_hz, f.shaft_hz / 2}, {2 * f.bsf_hz, f.cage_hz / 2}, {f.bpfo_hz, f.bpfo_hz / 4}};
}

/// The line stands out between its side lines (envelope_test.cpp). It lies between pure rolling and
/// 1 % slip, which lowers BPFO and BSF and raises BPFI, with 0.4 % tolerance for the speed (3
/// deviations of 0.1 %) and the bins.
TEST(Dynamics, EnvelopeShowsTheFaultFrequencyOfTheClass) {
  constexpr std::size_t length = 32768;
  const signal::WindowSet windows = generate("dynamics", model(three_faults(length)), 2);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto window = windows.window(i);
    const int label = windows.labels[i];
    SCOPED_TRACE(windows.info.classes[label].name);
    const bearing::EnvelopeSpectrum spectrum({window.begin(), window.end()}, 12000);
    const Line rolling = lines(0)[label];
    const Line slipping = lines(0.01)[label];
    const double low_hz = rolling.hz - rolling.reach_hz;
    const double high_hz = rolling.hz + rolling.reach_hz;
    const double highest_hz = spectrum.highest_line_hz(low_hz, high_hz);
    EXPECT_GT(highest_hz, 0.996 * std::min(rolling.hz, slipping.hz));
    EXPECT_LT(highest_hz, 1.004 * std::max(rolling.hz, slipping.hz));
    EXPECT_GT(spectrum.line(highest_hz), 10 * spectrum.median(low_hz, high_hz));
  }
}

TEST(Dynamics, DoesNotDependOnTheNumberOfThreads) {
  const std::filesystem::path path = model(three_faults(256));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const signal::WindowSet one = generate("dynamics", path, 3);
  omp_set_num_threads(3);
  const signal::WindowSet three = generate("dynamics", path, 3);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.samples, three.samples);
}

TEST(Dynamics, StoresStiffnessAndDampingOfEachWindow) {
  const auto path = model(three_faults(64),
                          "--stiffness-n-per-m 2e8 --stiffness-spread 0 "
                          "--damping-ns-per-m 700 --damping-spread 0.1");
  const signal::WindowSet windows = generate("dynamics", path, 2);
  ASSERT_EQ(windows.parameters.size(), windows.size());
  for (const signal::DynamicParameters& p : windows.parameters) {
    EXPECT_EQ(p.stiffness_n_per_m, 2e8);
    EXPECT_NEAR(p.damping_ns_per_m, 700, 210);
  }
  EXPECT_NE(windows.parameters[0].damping_ns_per_m, windows.parameters[1].damping_ns_per_m);
}

TEST(Dynamics, RefusesALoadThatDoesNotCloseTheClearance) {
  EXPECT_ERROR(model(three_faults(64), "--load-n 250"), Exit::usage,
               "--load-n 250: must exceed 260");
}

TEST(Dynamics, RefusesSpreadsThatAllowNegativeParameters) {
  for (const std::string option : {"--stiffness-spread", "--damping-spread", "--speed-spread"}) {
    EXPECT_THROW(method_with("dynamics", option + " 0.34"), cli::Refused) << option;
    EXPECT_THROW(method_with("dynamics", option + " -0.1"), cli::Refused) << option;
    EXPECT_THROW(method_with("dynamics", option + " nan"), cli::Refused) << option;
  }
}

TEST(Dynamics, NamesTheClassForWhichEq13Diverged) {
  const auto path = model(three_faults(64), "--damping-ns-per-m 1e8");
  EXPECT_ERROR(generate("dynamics", path, 1), Exit::failed, "class IR: eq. 13 diverged");
}

}  // namespace
}  // namespace piae::augment
