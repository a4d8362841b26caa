#include "scoring/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::scoring {
namespace {

using Bins = std::vector<std::complex<double>>;

/// The sum that defines the transform.
Bins by_definition(const std::vector<double>& samples) {
  Bins bins(samples.size());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    for (std::size_t n = 0; n < samples.size(); ++n) {
      bins[k] += samples[n] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k * n) /
                                                  static_cast<double>(samples.size()));
    }
  }
  return bins;
}

TEST(Fourier, ForwardIsTheSumThatDefinesItForAnyLength) {
  Fourier fft;
  for (const std::size_t length : {6U, 7U, 16U}) {
    std::vector<double> samples(length);
    for (std::size_t n = 0; n < length; ++n) samples[n] = std::sin(static_cast<double>(n * n));
    const Bins expected = by_definition(samples);
    Bins bins;
    fft.forward(bins, samples);
    ASSERT_EQ(bins.size(), length);
    for (std::size_t k = 0; k < length; ++k) EXPECT_LT(std::abs(bins[k] - expected[k]), 1e-12);
  }
}

TEST(Fourier, InverseGivesTheSamplesBack) {
  Fourier fft;
  const std::vector<double> samples{3, -1, 4, 1, -5, 9};
  Bins bins;
  fft.forward(bins, samples);
  std::vector<double> back;
  fft.inverse(back, bins);
  ASSERT_EQ(back.size(), samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) EXPECT_NEAR(back[n], samples[n], 1e-14);
}

}  // namespace
}  // namespace piae::scoring
