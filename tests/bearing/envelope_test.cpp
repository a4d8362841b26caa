// Proof of the whole model: the lines in the spectrum that a vibration analyst looks for.
#include <gtest/gtest.h>

#include "bearing/dynamics.hpp"
#include "support/envelope_spectrum.hpp"

namespace piae::bearing {
namespace {

constexpr double recorded_hz = 12000;
constexpr std::size_t samples = 65536;

struct Case {
  double size_mm, rpm;
};

class Envelope : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] FaultFrequencies frequencies() const {
    return fault_frequencies({}, GetParam().rpm);
  }
  [[nodiscard]] EnvelopeSpectrum spectrum(Defect fault_type, const DynamicsOptions& options) const {
    const Motion motion{.shaft_speed_rpm = GetParam().rpm, .cage_angle_rad = 0.3};
    return {simulate({}, {fault_type, GetParam().size_mm}, motion, options, {recorded_hz, samples}),
            recorded_hz};
  }
};

/// Damping that lets each burst die out before the next: bursts do not interfere, and the line
/// itself is higher than its side lines.
constexpr DynamicsOptions short_bursts{.damping_ns_per_m = 2500};

/// Expects `line_hz` to be ten times above the floor between the line and its side lines.
void expect_line(const EnvelopeSpectrum& s, double line_hz, double side_hz) {
  const double low_hz = line_hz - side_hz / 2;
  const double high_hz = line_hz + side_hz / 2;
  EXPECT_NEAR(s.highest_line_hz(low_hz, high_hz) / line_hz, 1, 0.01);
  EXPECT_GT(s.line(line_hz), 10 * s.median(low_hz, high_hz));
}

TEST_P(Envelope, OfAnOuterDefectIsHighestAtBpfo) {
  const double bpfo_hz = frequencies().bpfo_hz;
  const EnvelopeSpectrum s = spectrum(Defect::outer, {});
  EXPECT_NEAR(s.highest_line_hz(5, 1000) / bpfo_hz, 1, 0.01);
  expect_line(s, bpfo_hz, bpfo_hz / 2);
}

/// An inner defect passes the load zone once per shaft turn, which leaves shaft harmonics below
/// half of BPFI, and side lines.
TEST_P(Envelope, OfAnInnerDefectIsHighestAtBpfi) {
  const double bpfi_hz = frequencies().bpfi_hz;
  const EnvelopeSpectrum s = spectrum(Defect::inner, short_bursts);
  EXPECT_NEAR(s.highest_line_hz(bpfi_hz / 2, 1000) / bpfi_hz, 1, 0.01);
}

TEST_P(Envelope, OfAnInnerDefectHasBpfiAndShaftSideLines) {
  const FaultFrequencies f = frequencies();
  const EnvelopeSpectrum s = spectrum(Defect::inner, {});
  expect_line(s, f.bpfi_hz, f.shaft_hz);
  expect_line(s, f.bpfi_hz - f.shaft_hz, f.shaft_hz);
  expect_line(s, f.bpfi_hz + f.shaft_hz, f.shaft_hz);
}

/// A faulty ball passes the load zone once per cage turn.
TEST_P(Envelope, OfARollerDefectIsHighestAtTwiceBsf) {
  const double impacts_hz = 2 * frequencies().bsf_hz;
  const EnvelopeSpectrum s = spectrum(Defect::roller, short_bursts);
  EXPECT_NEAR(s.highest_line_hz(impacts_hz / 2, 1000) / impacts_hz, 1, 0.01);
}

TEST_P(Envelope, OfARollerDefectHasTwiceBsfAndCageSideLines) {
  const FaultFrequencies f = frequencies();
  const EnvelopeSpectrum s = spectrum(Defect::roller, {});
  expect_line(s, 2 * f.bsf_hz, f.cage_hz);
  expect_line(s, 2 * f.bsf_hz - f.cage_hz, f.cage_hz);
  expect_line(s, 2 * f.bsf_hz + f.cage_hz, f.cage_hz);
}

INSTANTIATE_TEST_SUITE_P(SizesAndSpeeds, Envelope,
                         testing::Values(Case{0.1778, 1797}, Case{0.5334, 1797},
                                         Case{0.1778, 1500}));

}  // namespace
}  // namespace piae::bearing
