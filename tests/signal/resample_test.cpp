#include "signal/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::signal {
namespace {

std::vector<double> sine(double hz, double rate_hz, std::size_t samples) {
  std::vector<double> x(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    x[i] = std::sin(2 * std::numbers::pi * hz * static_cast<double>(i) / rate_hz);
  }
  return x;
}

/// Largest difference, leaving out where the ends of the signal are felt.
double inner_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 1000; i + 1000 < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

TEST(Resample, KeepsASineBelowTheNewNyquistFrequency) {
  for (const double from : {48000.0, 51200.0, 10000.0}) {
    const auto out = resample(sine(1234.5, from, 40000), from, 12000);
    const auto expected = sine(1234.5, 12000, out.size());
    EXPECT_LT(inner_difference(out, expected), 1e-7) << from;
  }
}

TEST(Resample, RemovesWhatLiesAboveIt) {
  const auto out = resample(sine(9000, 48000, 40000), 48000, 12000);
  EXPECT_LT(inner_difference(out, std::vector<double>(out.size(), 0.0)), 1e-7);
}

TEST(Resample, GivesAllWholeSamples) {
  EXPECT_EQ(resample(std::vector<double>(243938, 0.0), 48000, 12000).size(), 60984U);
  EXPECT_EQ(resample(std::vector<double>(262144, 0.0), 51200, 12000).size(), 61440U);
  EXPECT_EQ(resample(std::vector<double>(10, 0.0), 6000, 12000).size(), 20U);
  EXPECT_EQ(resample(std::vector<double>(3, 0.0), 48000, 12000).size(), 0U);
}

TEST(Resample, LeavesEqualRatesAlone) {
  const auto in = sine(50, 1000, 77);
  EXPECT_EQ(resample(in, 12000, 12000), in);
}

}  // namespace
}  // namespace piae::signal
