#include "inspection/value_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/made_recordings.hpp"

namespace piae::inspection {
namespace {

using std::numbers::pi;
using Samples = std::vector<double>;

constexpr std::size_t length = 24000;

Samples noise(double deviation, const std::string& name) {
  Stream random(name);
  Samples samples(length);
  for (double& x : samples) x = random.normal(0, deviation);
  return samples;
}

Samples rounded(Samples samples, double step) {
  for (double& x : samples) x = step * std::round(x / step);
  return samples;
}

Samples clamped(Samples samples, double low, double high) {
  for (double& x : samples) x = std::clamp(x, low, high);
  return samples;
}

/// Returns a sine at full scale of a converter with this many bits, with a period in samples.
Samples full_scale_sine(double period, double phase, int bits) {
  Samples samples(length);
  for (std::size_t i = 0; i < length; ++i) {
    samples[i] = std::sin(2 * pi * static_cast<double>(i) / period + phase);
  }
  return rounded(samples, std::ldexp(1, 1 - bits));
}

std::size_t count_of(const Samples& samples, double value) {
  return static_cast<std::size_t>(std::ranges::count(samples, value));
}

TEST(FewValues, AreCountedUpToSixteen) {
  Samples dead(length);
  Stream random("dead sensor");
  const std::vector<double> values{-0.002, 0, 0.002, 0.005};
  for (double& x : dead) x = values[random.below(4)];
  EXPECT_EQ(few_values(dead), 4U);
  for (std::size_t i = 0; i < length; ++i) dead[i] = static_cast<double>(i % 16);
  EXPECT_EQ(few_values(dead), 16U);
  for (std::size_t i = 0; i < length; ++i) dead[i] = static_cast<double>(i % 17);
  EXPECT_EQ(few_values(dead), std::nullopt);
}

TEST(FewValues, AreNotReportedForAWorkingConverterOrAShortRecord) {
  EXPECT_EQ(few_values(noise(1, "fine")), std::nullopt);
  // Normal noise of three steps reaches about four deviations to either side: 24 values.
  EXPECT_EQ(few_values(rounded(noise(3, "coarse"), 1)), std::nullopt);
  Samples short_record;
  for (int i = 0; i < 30; ++i) short_record.push_back(i % 7);
  EXPECT_EQ(few_values(short_record), std::nullopt);
}

/// White noise has peaks of one sample.
TEST(CutTops, CountSingleSamples) {
  const Samples whole = noise(1, "white");
  const Samples cut = clamped(whole, -3, 2.5);
  const CutTops found = cut_tops(cut);
  const auto above = std::ranges::count_if(whole, [](double x) { return x >= 2.5; });
  const auto below = std::ranges::count_if(whole, [](double x) { return x <= -3; });
  EXPECT_EQ(found.on_highest, static_cast<std::size_t>(above));
  EXPECT_EQ(found.on_lowest, static_cast<std::size_t>(below));
  EXPECT_EQ(found.highest, 2.5);
  EXPECT_EQ(found.lowest, -3);
  EXPECT_EQ(found.samples(), static_cast<std::size_t>(above + below));
}

TEST(CutTops, AreCountedSeparatelyAtEachEnd) {
  const CutTops found = cut_tops(clamped(noise(1, "white"), -100, 2.5));
  EXPECT_GT(found.on_highest, 100U);
  EXPECT_EQ(found.on_lowest, 0U);
}

TEST(CutTops, AreFoundInImpactsAndCoarseConverters) {
  const Samples impacts = impact_recording(12000, 2, 107, "cut");
  const Samples cut = clamped(impacts, -0.3, 0.3);
  EXPECT_EQ(cut_tops(cut).on_highest, count_of(cut, 0.3));
  EXPECT_EQ(cut_tops(cut).on_lowest, count_of(cut, -0.3));
  const Samples coarse = clamped(rounded(noise(1, "white"), 1.0 / 32), -2, 2);
  EXPECT_EQ(cut_tops(coarse).on_highest, count_of(coarse, 2));
}

/// One UESTC record has 13 of 262144 samples on +10 V, and all others differ.
TEST(CutTops, AreFoundForAFewPeaksOfFineResolution) {
  Samples samples = rounded(noise(1, "white"), 1e-6);
  for (std::size_t i = 0; i < 9; ++i) samples[1000 * i + 500] = 5;
  EXPECT_EQ(cut_tops(samples).on_highest, 9U);
  EXPECT_EQ(cut_tops(samples).on_lowest, 0U);
}

TEST(CutTops, AreNotFoundInNoiseOfAnyResolution) {
  for (int record = 0; record < 50; ++record) {
    const Samples fine = noise(1, "noise/" + std::to_string(record));
    EXPECT_EQ(cut_tops(fine).samples(), 0U) << record;
    for (const double step : {1e-6, 1 / 512.0, 1 / 32.0, 0.1, 0.5}) {
      EXPECT_EQ(cut_tops(rounded(fine, step)).samples(), 0U) << record << ' ' << step;
    }
  }
}

TEST(CutTops, AreNotFoundInAFaultsImpacts) {
  for (const double impacts_hz : {20.0, 107.0, 120.0, 162.2}) {
    const Samples impacts = impact_recording(12000, 2, impacts_hz, "impacts");
    EXPECT_EQ(cut_tops(impacts).samples(), 0U) << impacts_hz;
    for (const double step : {1e-6, 1 / 2048.0, 0.02}) {
      EXPECT_EQ(cut_tops(rounded(impacts, step)).samples(), 0U) << impacts_hz << ' ' << step;
    }
  }
}

/// Equal peaks are the hardest case: over a whole period the same samples recur, except for
/// rounding. Rounding affects peaks least, and so makes them more equal.
TEST(CutTops, AreNotFoundInASineAtFullScale) {
  for (const double period : {2.5, 3.0, 4.0, 7.3, 10.0, 100.0, 97.31, 934.58, 6000.0}) {
    for (const double phase : {0.0, 0.4, pi / 4, pi / 2}) {
      for (const int bits : {8, 12, 16, 24, 40, 60}) {
        EXPECT_EQ(cut_tops(full_scale_sine(period, phase, bits)).samples(), 0U)
            << period << ' ' << phase << ' ' << bits;
      }
    }
  }
}

TEST(CutTops, AreNotFoundInASineInNoise) {
  Samples samples = noise(0.01, "sine in noise");
  for (std::size_t i = 0; i < length; ++i) {
    samples[i] += std::sin(2 * pi * 0.0137 * static_cast<double>(i));
  }
  for (const double step : {1e-6, 1 / 2048.0, 1 / 128.0}) {
    EXPECT_EQ(cut_tops(rounded(samples, step)).samples(), 0U) << step;
  }
}

/// Samples that a recorder repeats are one visit.
TEST(CutTops, AreNotFoundInRepeatedSamples) {
  Samples twelvefold;
  for (const double x : noise(1, "held")) twelvefold.insert(twelvefold.end(), 12, x);
  EXPECT_EQ(cut_tops(twelvefold).samples(), 0U);
  EXPECT_EQ(cut_tops({}).samples(), 0U);
  EXPECT_EQ(cut_tops(Samples(100, 1.0)).samples(), 0U);
}

}  // namespace
}  // namespace piae::inspection
