#include "inspection/repeats.hpp"

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

Samples vibration(const std::string& name = "impacts") {
  return impact_recording(12000, 2, 107, name);
}

/// Copies a stretch within a signal.
void copy_stretch(Samples& samples, std::size_t from, std::size_t to, std::size_t count) {
  std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(from), count,
              samples.begin() + static_cast<std::ptrdiff_t>(to));
}

TEST(Repeats, CountARepeatedHalfAsOneStretch) {
  Samples samples = vibration();
  copy_stretch(samples, 0, 12000, 12000);
  const Repeats found = repeats(samples);
  EXPECT_EQ(found.count, 1U);
  EXPECT_EQ(found.samples, 12000U);
  EXPECT_EQ(found.longest, 12000U);
  EXPECT_EQ(found.first, 12000U);
  EXPECT_EQ(found.original, 0U);
}

/// Blocks do not need to begin where a stretch does.
TEST(Repeats, FindAShortStretchAnywhere) {
  for (const std::size_t from : {0U, 1U, 17U, 5003U}) {
    for (const std::size_t count : {100U, 101U, 1024U}) {
      Samples samples = vibration();
      copy_stretch(samples, from, 15011, count);
      const Repeats found = repeats(samples);
      EXPECT_EQ(found.count, 1U) << from << ' ' << count;
      EXPECT_EQ(found.first, 15011U);
      EXPECT_EQ(found.original, from);
      EXPECT_EQ(found.longest, count);
    }
  }
}

TEST(Repeats, AddUpSeveralStretches) {
  Samples samples = vibration();
  copy_stretch(samples, 1000, 8000, 500);
  copy_stretch(samples, 3000, 15000, 700);
  copy_stretch(samples, 1000, 20000, 500);
  const Repeats found = repeats(samples);
  EXPECT_EQ(found.count, 3U);
  EXPECT_EQ(found.samples, 1700U);
  EXPECT_EQ(found.longest, 700U);
  EXPECT_EQ(found.first, 15000U);
  EXPECT_EQ(found.original, 3000U);
}

TEST(Repeats, IgnoreTheSignOfZero) {
  Samples samples = vibration();
  samples[500] = 0.0;
  copy_stretch(samples, 400, 9000, 300);
  samples[9100] = -0.0;
  EXPECT_EQ(repeats(samples).longest, 300U);
}

TEST(Repeats, AreNotFoundInNoiseOfAnyResolution) {
  for (const double step : {1e-6, 0.01, 0.1, 0.3}) {
    for (int record = 0; record < 5; ++record) {
      Samples samples = impact_recording(12000, 10, 0, "noise/" + std::to_string(record));
      for (double& x : samples) x = step * std::round(x / step);
      EXPECT_EQ(repeats(samples).count, 0U) << step << ' ' << record;
    }
  }
}

TEST(Repeats, AreNotConstantsOrSlopesOrShortStretches) {
  Samples zeros = vibration();
  std::fill_n(zeros.begin() + 3000, 2000, 0.0);
  std::fill_n(zeros.begin() + 9000, 2000, 0.0);
  EXPECT_EQ(repeats(zeros).count, 0U);
  // A converter of 200 steps; the cycle of the sine takes 934.58 samples.
  Samples slow(20000);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    slow[i] = std::round(100 * std::sin(2 * pi * 0.00107 * static_cast<double>(i)));
  }
  EXPECT_EQ(repeats(slow).count, 0U);
  Samples samples = vibration();
  copy_stretch(samples, 700, 9000, 60);
  EXPECT_EQ(repeats(samples).count, 0U);
}

TEST(Repeats, FindTheWholePeriodOfAComputedSignal) {
  Samples sine(24000);
  for (std::size_t i = 0; i < sine.size(); ++i) {
    sine[i] = std::round(1e6 * std::sin(2 * pi * static_cast<double>(i % 100) / 100));
  }
  const Repeats found = repeats(sine);
  EXPECT_EQ(found.original, 0U);
  EXPECT_EQ(found.first, 100U);
  EXPECT_EQ(found.longest, 23900U);
}

TEST(Repeats, AreNotFoundInShortRecords) {
  EXPECT_EQ(repeats({}).count, 0U);
  EXPECT_EQ(repeats(Samples(31, 1.0)).count, 0U);
  EXPECT_EQ(repeats(Samples(32, 1.0)).count, 0U);
  EXPECT_EQ(repeats(Samples(33, 1.0)).count, 0U);
}

}  // namespace
}  // namespace piae::inspection
