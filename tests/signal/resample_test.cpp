#include "signal/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace piae::signal {
namespace {

std::vector<double> sine(double hz, double rate_hz, std::size_t samples) {
  std::vector<double> x(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    x[i] = std::sin(2 * std::numbers::pi * hz * static_cast<double>(i) / rate_hz);
  }
  return x;
}

/// Returns the largest difference without the samples near the ends of the signal.
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

TEST(Resample, RemovesFrequenciesAboveIt) {
  const auto out = resample(sine(9000, 48000, 40000), 48000, 12000);
  EXPECT_LT(inner_difference(out, std::vector<double>(out.size(), 0.0)), 1e-7);
}

TEST(Resample, GivesEveryWholeSample) {
  EXPECT_EQ(resample(std::vector<double>(243938, 0.0), 48000, 12000).size(), 60984U);
  EXPECT_EQ(resample(std::vector<double>(262144, 0.0), 51200, 12000).size(), 61440U);
  EXPECT_EQ(resample(std::vector<double>(10, 0.0), 6000, 12000).size(), 20U);
  EXPECT_EQ(resample(std::vector<double>(3, 0.0), 48000, 12000).size(), 0U);
}

TEST(Resample, CopiesAtEqualRates) {
  const auto in = sine(50, 1000, 77);
  EXPECT_EQ(resample(in, 12000, 12000), in);
}

std::vector<double> resampled_in_pieces(const std::vector<double>& signal, double from_hz,
                                        double to_hz, std::size_t piece) {
  StreamResampler resampler(from_hz, to_hz);
  std::vector<double> out;
  for (std::size_t at = 0; at < signal.size(); at += piece) {
    resampler.add(std::span(signal).subspan(at, std::min(piece, signal.size() - at)), out);
  }
  resampler.finish(out);
  return out;
}

TEST(StreamResampler, MatchesResamplingOfTheWholeSignal) {
  Stream random("resampler");
  std::vector<double> signal(20000);
  for (double& x : signal) x = random.normal(0, 1);
  for (const double from_hz : {12000.0, 25600.0, 51200.0}) {
    const auto whole = resample(signal, from_hz, 12000);
    for (const std::size_t piece : {1, 333, 4096, 100000}) {
      const auto out = resampled_in_pieces(signal, from_hz, 12000, piece);
      ASSERT_GE(out.size(), whole.size());
      ASSERT_LE(out.size(), whole.size() + 1);
      for (std::size_t i = 0; i < whole.size(); ++i) {
        ASSERT_NEAR(out[i], whole[i], 1e-9) << from_hz << ' ' << piece << ' ' << i;
      }
    }
  }
}

TEST(StreamResampler, GivesNothingForNothing) {
  std::vector<double> out;
  StreamResampler resampler(48000, 12000);
  resampler.add({}, out);
  EXPECT_TRUE(out.empty());
  resampler.add(std::vector<double>{1, 2}, out);
  resampler.add({}, out);
  resampler.add(std::vector<double>(20000, 1.0), out);
  EXPECT_GT(out.size(), 4000U);
}

}  // namespace
}  // namespace piae::signal
