#include "diagnosis/log_envelope_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::diagnosis {
namespace {

using Eigen::Index;

/// A carrier of 200 cycles and amplitude 2 in 1024 samples, modulated at 12 cycles.
scoring::Windows modulated(double depth) {
  constexpr double cycle = 2 * std::numbers::pi / 1024;
  scoring::Windows window(1, 1024);
  for (Index t = 0; t < 1024; ++t) {
    const auto at = static_cast<double>(t);
    window(0, t) =
        2 * (1 + depth * std::cos(12 * cycle * at)) * std::sin(200 * cycle * at + 1) + 0.5;
  }
  return window;
}

// The carrier has no line; that of its modulation is as high as it swings.
TEST(LogEnvelopeSpectrum, OfAModulatedCarrierIsItsModulation) {
  const Eigen::ArrayXd bands = log_envelope_spectrum(modulated(0.3), 1024, 1e-6);
  ASSERT_EQ(bands.size(), 1024);
  Index highest = 0;
  EXPECT_NEAR(bands.maxCoeff(&highest), std::log(2 * 0.3), 1e-9);
  EXPECT_EQ(highest, 23);
  EXPECT_NEAR(bands[399], std::log(1e-6), 1e-9);
}

TEST(LogEnvelopeSpectrum, OfASteadyCarrierIsTheFloor) {
  const Eigen::ArrayXd bands = log_envelope_spectrum(modulated(0), 512, 1e-6);
  ASSERT_EQ(bands.size(), 512);
  EXPECT_EQ(bands.maxCoeff(), std::log(1e-6));
}

}  // namespace
}  // namespace piae::diagnosis
