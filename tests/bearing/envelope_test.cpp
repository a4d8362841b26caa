// The proof of the whole model: the lines that a vibration analyst looks for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "bearing/dynamics.hpp"

namespace piae::bearing {
namespace {

constexpr double rate_hz = 12000;
constexpr std::size_t samples = 65536;
constexpr std::size_t padded =
    2 * samples;  // and a Hann window: lines keep their height within 4 %
constexpr double bin_hz = rate_hz / padded;

using Complex = std::complex<double>;
using Spectrum = std::vector<double>;

/// The signal around the resonance (1.8 kHz) with its negative frequencies taken away.
std::vector<Complex> analytic(const std::vector<double>& signal) {
  Eigen::FFT<double> fft;
  std::vector<Complex> spectrum;
  fft.fwd(spectrum, std::vector<Complex>(signal.begin(), signal.end()));
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double hz = static_cast<double>(i) * rate_hz / samples;
    if (hz < 1000 || hz > 3000) spectrum[i] = 0;  // all above rate / 2 are negative frequencies
  }
  std::vector<Complex> result;
  fft.inv(result, spectrum);
  return result;
}

/// Amplitudes of the Hilbert envelope, by frequency bin.
Spectrum envelope_spectrum(const std::vector<double>& signal) {
  std::vector<Complex> envelope = analytic(signal);
  double mean = 0;
  for (Complex& x : envelope) {
    x = std::abs(x);
    mean += x.real() / samples;
  }
  for (std::size_t i = 0; i < samples; ++i) {
    envelope[i] = (envelope[i] - mean) * (1 - std::cos(2 * std::numbers::pi * i / samples));
  }
  envelope.resize(padded);
  Eigen::FFT<double> fft;
  std::vector<Complex> spectrum;
  fft.fwd(spectrum, envelope);
  Spectrum amplitudes(padded / 2);
  for (std::size_t i = 0; i < amplitudes.size(); ++i) amplitudes[i] = std::abs(spectrum[i]);
  return amplitudes;
}

std::size_t bin(double hz) { return static_cast<std::size_t>(std::lround(hz / bin_hz)); }

double highest_line_hz(const Spectrum& s, double low_hz, double high_hz) {
  const auto highest = std::max_element(s.begin() + bin(low_hz), s.begin() + bin(high_hz));
  return static_cast<double>(highest - s.begin()) * bin_hz;
}

double line(const Spectrum& s, double hz) {
  return *std::max_element(s.begin() + bin(hz) - 4, s.begin() + bin(hz) + 5);
}

double median(const Spectrum& s, double low_hz, double high_hz) {
  Spectrum part(s.begin() + bin(low_hz), s.begin() + bin(high_hz));
  std::ranges::sort(part);
  return part[part.size() / 2];
}

struct Case {
  double size_mm, rpm;
};

class EnvelopeSpectrum : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] FaultFrequencies frequencies() const {
    return fault_frequencies({}, GetParam().rpm);
  }
  [[nodiscard]] Spectrum spectrum(Defect kind, const DynamicsOptions& options) const {
    const Motion motion{.shaft_speed_rpm = GetParam().rpm, .cage_angle_rad = 0.3};
    return envelope_spectrum(
        simulate({}, {kind, GetParam().size_mm}, motion, options, {rate_hz, samples}));
  }
};

/// So damped that one burst has died out before the next: their lines do not interfere, and of a
/// line and its side lines the line itself is the highest.
constexpr DynamicsOptions short_bursts{.damping_ns_per_m = 2500};

/// `line_hz` stands ten times above what lies between it and its side lines.
void expect_line(const Spectrum& s, double line_hz, double side_hz) {
  const double low_hz = line_hz - side_hz / 2;
  const double high_hz = line_hz + side_hz / 2;
  EXPECT_NEAR(highest_line_hz(s, low_hz, high_hz) / line_hz, 1, 0.01);
  EXPECT_GT(line(s, line_hz), 10 * median(s, low_hz, high_hz));
}

TEST_P(EnvelopeSpectrum, OfAnOuterDefectIsHighestAtBpfo) {
  const double bpfo_hz = frequencies().bpfo_hz;
  const Spectrum s = spectrum(Defect::outer, {});
  EXPECT_NEAR(highest_line_hz(s, 5, 1000) / bpfo_hz, 1, 0.01);
  expect_line(s, bpfo_hz, bpfo_hz / 2);
}

/// An inner defect goes through the load zone once in a turn of the shaft, which leaves shaft
/// harmonics below half of BPFI, and side lines.
TEST_P(EnvelopeSpectrum, OfAnInnerDefectIsHighestAtBpfi) {
  const double bpfi_hz = frequencies().bpfi_hz;
  const Spectrum s = spectrum(Defect::inner, short_bursts);
  EXPECT_NEAR(highest_line_hz(s, bpfi_hz / 2, 1000) / bpfi_hz, 1, 0.01);
}

TEST_P(EnvelopeSpectrum, OfAnInnerDefectHasBpfiAndShaftSideLines) {
  const FaultFrequencies f = frequencies();
  const Spectrum s = spectrum(Defect::inner, {});
  expect_line(s, f.bpfi_hz, f.shaft_hz);
  expect_line(s, f.bpfi_hz - f.shaft_hz, f.shaft_hz);
  expect_line(s, f.bpfi_hz + f.shaft_hz, f.shaft_hz);
}

/// A faulty ball goes through the load zone once in a turn of the cage.
TEST_P(EnvelopeSpectrum, OfARollerDefectIsHighestAtTwiceBsf) {
  const double strikes_hz = 2 * frequencies().bsf_hz;
  const Spectrum s = spectrum(Defect::roller, short_bursts);
  EXPECT_NEAR(highest_line_hz(s, strikes_hz / 2, 1000) / strikes_hz, 1, 0.01);
}

TEST_P(EnvelopeSpectrum, OfARollerDefectHasTwiceBsfAndCageSideLines) {
  const FaultFrequencies f = frequencies();
  const Spectrum s = spectrum(Defect::roller, {});
  expect_line(s, 2 * f.bsf_hz, f.cage_hz);
  expect_line(s, 2 * f.bsf_hz - f.cage_hz, f.cage_hz);
  expect_line(s, 2 * f.bsf_hz + f.cage_hz, f.cage_hz);
}

INSTANTIATE_TEST_SUITE_P(SizesAndSpeeds, EnvelopeSpectrum,
                         testing::Values(Case{0.1778, 1797}, Case{0.5334, 1797},
                                         Case{0.1778, 1500}));

}  // namespace
}  // namespace piae::bearing
