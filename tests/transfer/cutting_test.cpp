#include "transfer/cutting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "transfer/ringing.hpp"

namespace piae::transfer {
namespace {

constexpr Comb known{.first = 60, .period = 160};

double power(const std::vector<double>& window) {
  double sum = 0;
  for (const double x : window) sum += x * x;
  return sum;
}

TEST(Cutting, CutsTheWholeResponseAfterEachImpact) {
  std::vector<double> window(1024);
  for (std::size_t i = 0; i < window.size(); ++i) window[i] = static_cast<double>(i);
  const std::vector<Cut> responses = cut_responses(window, known);
  // Impacts at 60, 220, ... 860, 1020, each cut 19 samples before it; the last cut is not whole.
  ASSERT_EQ(responses.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(responses[i].size(), 160U);
    EXPECT_EQ(responses[i].front(), static_cast<double>(41 + 160 * i));
  }
}

TEST(Cutting, MovesImpactsToTheNewPeriodAndKeepsEachRinging) {
  const std::vector<Cut> responses = cut_responses(ringing(60, 160, 1024), known);
  for (const double period : {80.0, 160.0, 213.3, 320.0}) {
    Stream random("struck at " + std::to_string(period));
    const std::vector<double> window =
        with_impacts(responses, {.period = period, .jitter = 0}, 1024, random).samples;
    const Comb comb = find_comb(window, period);
    EXPECT_NEAR(comb.period, period, 0.006 * period) << period;
    // The ringing after each impact is the same, so the power grows with the number of impacts.
    const double expected = power(ringing(0, 160, 16000)) * 160 / 16000 / period * 1024;
    EXPECT_NEAR(power(window) / expected, 1, 0.15) << period;
  }
}

TEST(Cutting, StoresItsImpactTimes) {
  // The impact of a response of 100 samples is 12 samples after its beginning, where it was cut.
  std::vector<Cut> responses(2, Cut(100, 0.0));
  for (Cut& response : responses) response[12] = 1;
  Stream random("strikes");
  const ImpactWindow window = with_impacts(responses, {.period = 70, .jitter = 0.02}, 1024, random);
  ASSERT_GE(window.impact_positions.size(), 13U);
  for (const double strike : window.impact_positions) {
    const auto place = static_cast<std::size_t>(std::lround(strike));
    EXPECT_EQ(window.samples[std::min<std::size_t>(place, 1023)], 1) << strike;
  }
}

TEST(Cutting, KeepsTheOrderOfResponses) {
  // Responses of levels 1, 2 and 3: a race that passes the load zone once per three impacts.
  std::vector<Cut> responses(3, Cut(100, 0.0));
  for (std::size_t i = 0; i < 3; ++i) responses[i][10] = static_cast<double>(i + 1);
  Stream random("order");
  const std::vector<double> window =
      with_impacts(responses, {.period = 50, .jitter = 0}, 1024, random).samples;
  std::vector<double> strengths;
  for (const double x : window) {
    if (x > 0) strengths.push_back(x);
  }
  ASSERT_GE(strengths.size(), 20U);
  for (std::size_t i = 1; i < strengths.size(); ++i) {
    EXPECT_EQ(strengths[i], strengths[i - 1] == 3 ? 1 : strengths[i - 1] + 1) << i;
  }
}

TEST(Cutting, HasTheRequestedJitter) {
  std::vector<Cut> responses(1, Cut(50, 0.0));
  responses[0][0] = 1;
  Stream random("irregular");
  double squares = 0;
  double impact_positions = 0;
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> window =
        with_impacts(responses, {.period = 50, .jitter = 0.04}, 1024, random).samples;
    std::vector<double> places;
    for (std::size_t t = 0; t < window.size(); ++t) {
      if (window[t] > 0.5) places.push_back(static_cast<double>(t));
    }
    for (std::size_t j = 1; j < places.size(); ++j) {
      squares += std::pow((places[j] - places[j - 1]) / 50 - 1, 2);
      ++impact_positions;
    }
  }
  // Rounding to samples adds 1/50 * sqrt(1/6): in total 0.0408.
  EXPECT_NEAR(std::sqrt(squares / impact_positions), 0.0408, 0.003);
}

TEST(Cutting, ContinuesBeyondTheKnownPeriodAtTheLevelOfItsEnd) {
  // White noise of power 1 has the same power at any distance of impacts.
  Stream noise("noise");
  std::vector<double> window(1024);
  for (double& x : window) x = noise.normal(0, 1);
  const std::vector<Cut> responses = cut_responses(window, known);
  double sum = 0;
  for (int i = 0; i < 40; ++i) {
    Stream random("window " + std::to_string(i));
    sum +=
        power(with_impacts(responses, {.period = 400, .jitter = 0}, 1024, random).samples) / 1024;
  }
  EXPECT_NEAR(sum / 40, 1, 0.12);
}

}  // namespace
}  // namespace piae::transfer
