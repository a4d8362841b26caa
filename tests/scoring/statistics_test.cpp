#include "scoring/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/random.hpp"

namespace piae::scoring {
namespace {

TEST(Summary, MatchesTheHandWorkedTable6) {
  const Summary summary = summarise(std::vector<double>{61.8, 62.0, 61.7, 62.3, 62.3});
  EXPECT_EQ(summary.count, 5U);
  EXPECT_NEAR(summary.mean, 62.02, 1e-12);
  EXPECT_NEAR(*summary.deviation, std::sqrt(0.308 / 4), 1e-12);  // squares add up to 0.308
  const double half = 2.776445 * std::sqrt(0.308 / 4) / std::sqrt(5.0);
  EXPECT_NEAR(summary.interval->low, 62.02 - half, 1e-6);
  EXPECT_NEAR(summary.interval->high, 62.02 + half, 1e-6);
}

/// The half-width of n values with standard deviation 1 is t / sqrt(n); t is tabulated.
TEST(Summary, IntervalHasStudentsQuantiles) {
  const std::vector<std::pair<std::size_t, double>> table{{2, 12.7062}, {3, 4.3027},  {4, 3.1824},
                                                          {6, 2.5706},  {10, 2.2622}, {30, 2.0452}};
  for (const auto& [n, t] : table) {
    std::vector<double> values(n, 0.0);
    values[0] = std::sqrt(static_cast<double>(n));  // mean 1 / sqrt(n), deviation 1
    const Summary summary = summarise(values);
    EXPECT_NEAR(*summary.deviation, 1, 1e-12);
    EXPECT_NEAR((summary.interval->high - summary.mean) * values[0], t, 6e-5) << n;
    EXPECT_NEAR((summary.mean - summary.interval->low) * values[0], t, 6e-5) << n;
  }
}

TEST(Summary, OneValueHasNoSpread) {
  const Summary summary = summarise(std::vector<double>{7});
  EXPECT_EQ(summary.count, 1U);
  EXPECT_EQ(summary.mean, 7);
  EXPECT_FALSE(summary.deviation);
  EXPECT_FALSE(summary.interval);
}

TEST(Summary, EqualValuesGiveAPointInterval) {
  const Summary summary = summarise(std::vector<double>{3, 3, 3});
  EXPECT_EQ(*summary.deviation, 0);
  EXPECT_EQ(summary.interval->low, 3);
  EXPECT_EQ(summary.interval->high, 3);
}

TEST(Summary, NeedsAValue) { EXPECT_THROW(summarise({}), std::logic_error); }

/// Two classes of two: means 2 and 6 about 4, so 4 * 4 of 4 * 4 + 4 * 1 is between them.
TEST(ShareBetweenClasses, MatchesTheHandWorkedValue) {
  const std::vector<double> values{1, 7, 3, 5};
  const std::vector<Label> labels{0, 1, 0, 1};
  EXPECT_NEAR(share_between_classes(values, labels), 16.0 / 20.0, 1e-15);
}

TEST(ShareBetweenClasses, IsZeroWithoutVariationAndOneForVariationByClassOnly) {
  const std::vector<Label> labels{0, 0, 1};
  EXPECT_EQ(share_between_classes(std::vector<double>{2, 2, 2}, labels), 0);
  EXPECT_EQ(share_between_classes(std::vector<double>{2, 2, 5}, labels), 1);
}

TEST(ShareBetweenClasses, MatchesChanceForRandomClasses) {
  constexpr int repeats = 400;
  double sum = 0;
  Stream stream("share between classes");
  for (int i = 0; i < repeats; ++i) {
    std::vector<double> values;
    std::vector<Label> labels;
    for (int j = 0; j < 45; ++j) {
      values.push_back(stream.normal(3, 2));
      labels.push_back(j % 9);
    }
    sum += share_between_classes(values, labels);
  }
  EXPECT_NEAR(sum / repeats, 8.0 / 44.0, 0.015);  // its standard deviation is 0.08 / sqrt(400)
}

}  // namespace
}  // namespace piae::scoring
