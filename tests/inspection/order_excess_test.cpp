#include "inspection/order_excess.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/made_recordings.hpp"

namespace piae::inspection {
namespace {

using Eigen::ArrayXd;

constexpr double shaft_hz = 23;  // 50 and 60 Hz are 2.17 and 2.61 orders

ArrayXd no_lines() { return ArrayXd::Zero(7000); }

/// Returns lines of this height at the harmonics `first`, `first` + `step`, ... of an order.
ArrayXd lines_at(double order, double db, int first = 1, int step = 1) {
  ArrayXd lines = no_lines();
  for (int h = first; h * order < 69.9; h += step) lines[std::lround(h * order * 100)] = db;
  return lines;
}

TEST(OrderLines, ShowImpactsAtTheirOrder) {
  constexpr double rate_hz = 12000;
  const std::vector<double> signal = impact_recording(rate_hz, 6, 3.58 * 30, "order lines");
  const ArrayXd lines = order_lines_db(signal, rate_hz, 30);
  ASSERT_EQ(lines.size(), 7000);
  for (const int harmonic : {1, 2, 3}) EXPECT_GT(lines[harmonic * 358], 25) << harmonic;
  EXPECT_LT(lines[179], 15);
  EXPECT_LT(lines[537], 15);
}

/// 12 s at 600 rpm are 120 turns, 4.9 s are 49.
TEST(OrderLines, NeedEnoughTurnsAndASignal) {
  EXPECT_EQ(order_lines_db(std::vector<double>(24000, 3.0), 2000, 10).size(), 0);
  const std::vector<double> noise = impact_recording(2000, 12, 0, "turns");
  EXPECT_GT(order_lines_db(noise, 2000, 10).size(), 0);
  EXPECT_EQ(order_lines_db(std::span(noise).first(9800), 2000, 10).size(), 0);
}

/// The envelope of 200 Hz ends at 100 Hz, 10 orders of 10 Hz.
TEST(OrderLines, EndWithTheSpectrum) {
  const std::vector<double> noise = impact_recording(200, 60, 0, "end");
  const auto size = order_lines_db(noise, 200, 10).size();
  EXPECT_GT(size, 990);
  EXPECT_LE(size, 1000);
}

TEST(OrderExcess, IsTheMeanOverTheHarmonics) {
  const OrderExcess all(lines_at(3.3, 20), no_lines(), shaft_hz);
  const OrderExcess odd(lines_at(3.3, 20, 1, 2), no_lines(), shaft_hz);
  // 5, 10 and their neighbours are multiples of half an order: 16.5 and 33. No other is left out.
  EXPECT_NEAR(all.comb_db(3.3, 10).value(), 20, 1e-12);
  EXPECT_NEAR(odd.comb_db(3.3, 10).value(), 20 * 4.0 / 8, 1e-12);
  EXPECT_NEAR(odd.comb_db(3.3, 10, 2).value(), 20, 1e-12);
  EXPECT_NEAR(all.comb_db(1.65, 10, 2).value_or(-1), 0, 1e-12);
}

TEST(OrderExcess, CountsHarmonicsBeyondTheEndAsNothing) {
  const OrderExcess excess(lines_at(11.2, 20), no_lines(), shaft_hz);  // 6 of 10, two at n / 2
  EXPECT_NEAR(excess.comb_db(11.2, 10).value(), 20 * 5.0 / 9, 1e-12);
}

TEST(OrderExcess, LowersLinesThatTheHealthyRecordHasNearby) {
  const ArrayXd lines = lines_at(3.3, 20);
  const OrderExcess excess(lines, lines_at(3.3, 12), shaft_hz);
  EXPECT_NEAR(excess.comb_db(3.3, 3).value(), 8, 1e-12);
  const OrderExcess louder(lines, lines_at(3.3, 30), shaft_hz);
  EXPECT_NEAR(louder.comb_db(3.3, 3).value(), 0, 1e-12);
  const OrderExcess huge(lines_at(3.3, 90), no_lines(), shaft_hz);
  EXPECT_NEAR(huge.comb_db(3.3, 3).value(), 45, 1e-12);
}

TEST(OrderExcess, MeasuresSideBandsOnBothSides) {
  ArrayXd lines = lines_at(5.41, 30);
  for (int h = 1; h <= 6; ++h) lines[std::lround(h * 541) + 100] = 12;
  const OrderExcess excess(lines, no_lines(), shaft_hz);
  EXPECT_NEAR(excess.side_bands_db(5.41, 0), 30, 1e-12);
  EXPECT_NEAR(excess.side_bands_db(5.41, 1), 6, 1e-12);
  EXPECT_NEAR(excess.side_bands_db(5.41, 0.4), 0, 1e-12);
}

TEST(OrderExcess, KnowsTheOrdersOfShaftLoosenessAndMains) {
  const OrderExcess excess(no_lines(), no_lines(), shaft_hz);
  for (const double order : {3.0, 3.02, 2.5, 6.05, 50 / 23.0, 2 * 60 / 23.0}) {
    EXPECT_TRUE(excess.may_be_foreign(order)) << order;
  }
  for (const double order : {3.05, 3.58, 5.41, 4.71}) {
    EXPECT_FALSE(excess.may_be_foreign(order)) << order;
  }
  EXPECT_FALSE(excess.comb_db(3.0, 10));
}

}  // namespace
}  // namespace piae::inspection
