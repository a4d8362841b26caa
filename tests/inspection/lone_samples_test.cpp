#include "inspection/lone_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/made_recordings.hpp"

namespace piae::inspection {
namespace {

using std::numbers::pi;
using Samples = std::vector<double>;

Samples ringing(double impacts_hz = 107, const std::string& name = "impacts") {
  return impact_recording(12000, 2, impacts_hz, name);
}

TEST(LoneSamples, FindASpikeAndTheNextLargestSample) {
  Samples samples = ringing(0);
  samples[1000] = 300;
  samples[2000] = -0.55;  // the farthest of the others: noise of 0.1 reaches 0.45
  const LoneSamples found = lone_samples(samples);
  EXPECT_EQ(found.count, 1U);
  EXPECT_EQ(found.farthest, 1000U);
  EXPECT_EQ(found.value, 300);
  EXPECT_NEAR(found.others, 0.55 + 300.0 / 24000, 0.002);
}

TEST(LoneSamples, CountSpikesAndLocateTheFarthest) {
  Samples samples = ringing();
  const double between = 60;  // samples after an impact, of 112, where its ringing has decayed
  for (const int impact : {10, 50, 90}) {
    const auto at = static_cast<std::size_t>(std::lround(impact * 12000 / 107.0 + between));
    samples[at] = impact == 50 ? -9 : 7;
  }
  const LoneSamples found = lone_samples(samples);
  EXPECT_EQ(found.count, 3U);
  EXPECT_EQ(found.value, -9);
}

TEST(LoneSamples, FindASpikeAtAnEndOrOnADrift) {
  Samples samples = ringing(0);
  samples.front() = 40;
  EXPECT_EQ(lone_samples(samples).farthest, 0U);
  EXPECT_EQ(lone_samples(samples).count, 1U);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += 0.001 * static_cast<double>(i);
  samples.back() = 100;
  EXPECT_EQ(lone_samples(samples).farthest, samples.size() - 1);
}

/// A rate and a count of samples above whole numbers have the format of samples.
TEST(LoneSamples, FindNumbersOfAHeader) {
  for (const Samples& above : {Samples{12000, 24000}, Samples{5000, 6000, 4000}, Samples{5000}}) {
    Samples samples = above;
    for (const double x : ringing()) samples.push_back(std::round(900 * x));
    const LoneSamples found = lone_samples(samples);
    EXPECT_LT(found.others, 1500);
    EXPECT_EQ(found.count, above.size());
    EXPECT_LT(found.farthest, above.size());
  }
  Samples samples = ringing();
  samples[0] = samples[1] = 2 * lone_samples(samples).others;  // an impact just before the record
  EXPECT_EQ(lone_samples(samples).count, 0U);
}

TEST(LoneSamples, FindASpikeOfTwoSamples) {
  for (const auto& [first, second] :
       {std::pair{300., 300.}, std::pair{300., -300.}, std::pair{-300., -90.}, std::pair{80., 300.},
        std::pair{300., 0.4}}) {
    for (const std::size_t at : {0, 1000, 23'998}) {
      Samples samples = ringing(0);
      samples[at] = first;
      samples[at + 1] = second;
      const LoneSamples found = lone_samples(samples);
      const bool is_single = second == 0.4;
      EXPECT_EQ(found.count, is_single ? 1U : 2U) << at << " " << second;
      EXPECT_EQ(std::abs(found.value), 300) << at << " " << second;
      EXPECT_LT(found.others, 0.6) << at << " " << second;
    }
  }
}

TEST(LoneSamples, DoNotIncludeThreeInARow) {
  Samples samples = ringing(0);
  for (const std::size_t at : {1000, 1001, 1002}) samples[at] = 300;
  EXPECT_EQ(lone_samples(samples).count, 0U);
}

TEST(LoneSamples, AreNotFoundInNoise) {
  for (int record = 0; record < 20; ++record) {
    const Samples noise = ringing(0, "noise/" + std::to_string(record));
    EXPECT_EQ(lone_samples(noise).count, 0U) << record;
    Samples coarse = noise;
    for (double& x : coarse) x = std::round(x / 0.1);
    EXPECT_EQ(lone_samples(coarse).count, 0U) << record;
  }
}

TEST(LoneSamples, AreNotTheImpactsOfAFault) {
  for (const double impacts_hz : {1.0, 11.0, 107.0}) {
    EXPECT_EQ(lone_samples(ringing(impacts_hz)).count, 0U) << impacts_hz;
  }
}

/// A single impact, far above the noise, through the sharpest filter of a recorder.
TEST(LoneSamples, AreNotASingleImpactThatAFilterSharpened) {
  for (const double shift : {0.0, 0.2, 0.5}) {
    Samples samples = ringing(0);
    for (int k = -200; k <= 200; ++k) {
      const double t = k + shift;
      const double pulse = t == 0 ? 1 : std::sin(0.9 * pi * t) / (0.9 * pi * t);
      samples[static_cast<std::size_t>(12000 + k)] += 50 * pulse;
    }
    EXPECT_EQ(lone_samples(samples).count, 0U) << shift;
  }
}

/// Two such pulses, one sample apart. Their neighbours nearly cancel: of two equal ones, they reach
/// 0.014 of the height.
TEST(LoneSamples, AreNotTwoSamplesThatAFilterSharpened) {
  for (const double second : {1.0, 0.9, 0.5, 0.0, -0.5, -1.0}) {
    Samples samples(4000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto pulse = [&](double at) {
        const double t = 0.9 * pi * (static_cast<double>(i) - at);
        return t == 0 ? 1 : std::sin(t) / t;
      };
      samples[i] = 50 * (pulse(2000) + second * pulse(2001));
    }
    EXPECT_EQ(lone_samples(samples).count, 0U) << second;
  }
}

TEST(LoneSamples, AreNotFoundInAShortRecord) {
  EXPECT_EQ(lone_samples(Samples{0, 0, 9, 0, 0}).count, 0U);
  EXPECT_EQ(lone_samples({}).count, 0U);
}

}  // namespace
}  // namespace piae::inspection
