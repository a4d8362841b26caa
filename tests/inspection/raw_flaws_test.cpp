#include "inspection/raw_flaws.hpp"

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

Samples struck() { return impact_recording(12000, 2, 107, "raw flaws"); }

/// Rounds samples as a converter of this resolution does.
Samples quantised(Samples samples, double quantum) {
  for (double& x : samples) x = quantum * std::round(x / quantum);
  return samples;
}

Samples sine(double per_sample, double amplitude, std::size_t count) {
  Samples samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back(amplitude * std::sin(2 * pi * per_sample * static_cast<double>(i)));
  }
  return samples;
}

TEST(Monotonic, HoldsForATimeButNotForAVibration) {
  Samples time;
  for (int i = 0; i < 5000; ++i) time.push_back(0.3 + i / 51200.0);
  EXPECT_TRUE(goes_one_way(time));
  EXPECT_TRUE(goes_one_way(quantised(time, 0.001))) << "printed with few digits";
  std::ranges::reverse(time);
  EXPECT_TRUE(goes_one_way(time));
  time[2500] = time.front();
  EXPECT_TRUE(goes_one_way(time)) << "a counter that began anew";
  EXPECT_FALSE(goes_one_way(struck()));
  EXPECT_FALSE(goes_one_way(sine(0.001, 1, 5000)));
  EXPECT_FALSE(goes_one_way(Samples{1, 2, 3, 4, 5})) << "too few to tell";
}

/// asin(0.8) and asin(0.9) of a cycle of 100 samples: flat tops of 20 and 14 samples.
TEST(Clipped, CountsAndLocatesPeaks) {
  Samples samples = sine(0.01, 1, 12000);
  for (double& x : samples) x = std::clamp(x, -0.9, 0.8);
  const Stretches found = clipped_peaks(samples);
  EXPECT_EQ(found.count, 240U);
  const double cycle = 100 - 50 / pi * (2 * std::asin(0.8) + 2 * std::asin(0.9));
  EXPECT_NEAR(static_cast<double>(found.samples) / 120, cycle, 2);
  EXPECT_EQ(found.value, 0.8);
  EXPECT_EQ(samples[found.longest_first], 0.8);
}

Samples repeated(const Samples& samples, std::size_t times) {
  Samples all;
  for (const double x : samples) all.insert(all.end(), times, x);
  return all;
}

/// Logger programs write each sample twice if they are polled too fast.
TEST(Clipped, IsNotFoundWhereEachSampleIsWrittenTwice) {
  Samples clipped = struck();
  for (double& x : clipped) x = std::clamp(x, -0.3, 0.3);
  for (const std::size_t times : {2U, 3U}) {
    EXPECT_EQ(clipped_peaks(repeated(struck(), times)).count, 0U) << times;
    EXPECT_GT(clipped_peaks(repeated(clipped, times)).count, 20U) << times;
  }
}

TEST(Clipped, FindsClippedImpacts) {
  Samples samples = struck();
  for (double& x : samples) x = std::clamp(x, -0.25, 0.25);
  EXPECT_GT(clipped_peaks(samples).count, 20U);
}

TEST(Clipped, AcceptsWholePeaks) {
  EXPECT_EQ(clipped_peaks(struck()).count, 0U);
  for (const double quantum : {1e-4, 0.01, 0.05}) {
    EXPECT_EQ(clipped_peaks(quantised(struck(), quantum)).count, 0U) << quantum;
  }
}

/// The top of a slow sine of few steps is flat over many samples without clipping.
TEST(Clipped, AcceptsRoundedTopsOfACoarseConverter) {
  for (const double per_sample : {0.3, 0.031, 0.0103, 0.00107}) {
    const Samples samples = quantised(sine(per_sample, 1, 20000), 1 / 100.0);
    EXPECT_EQ(clipped_peaks(samples).count, 0U) << per_sample;
    EXPECT_EQ(held_values(samples).count, 0U) << per_sample;
  }
}

TEST(Held, CountsAndLocatesZerosInAVibration) {
  Samples samples = struck();
  std::fill_n(samples.begin() + 5000, 1200, 0.0);
  std::fill_n(samples.begin() + 15000, 300, 0.0);
  const Stretches found = held_values(samples);
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(found.samples, 1500U);
  EXPECT_EQ(found.longest, 1200U);
  EXPECT_EQ(found.longest_first, 5000U);
  EXPECT_EQ(found.value, 0);
}

TEST(Held, CountsAnyOtherValue) {
  Samples samples = struck();
  std::fill_n(samples.begin() + 700, 200, samples[699]);
  const Stretches found = held_values(samples);
  EXPECT_EQ(found.count, 1U);
  EXPECT_EQ(found.longest, 201U);
  EXPECT_EQ(found.longest_first, 699U);
}

TEST(Held, CountsMostOfARecord) {
  Samples samples = struck();
  std::fill(samples.begin() + 1000, samples.end(), 0.0);
  EXPECT_EQ(held_values(samples).longest, samples.size() - 1000);
}

TEST(Held, IgnoresValuesThatRepeatByChance) {
  // Three values on average: one step in four repeats.
  const Samples coarse = quantised(impact_recording(12000, 10, 0, "coarse"), 0.1);
  EXPECT_EQ(held_values(coarse).count, 0U);
  EXPECT_EQ(held_values(struck()).count, 0U);
  Samples twice;
  for (const double x : struck()) twice.insert(twice.end(), 12, x);
  EXPECT_EQ(held_values(twice).count, 0U) << "every sample written twelve times";
}

}  // namespace
}  // namespace piae::inspection
