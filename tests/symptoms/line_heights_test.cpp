#include "symptoms/line_heights.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace piae::symptoms {
namespace {

// n/2 (1 + d/D), D/d (1 - (d/D)^2), n/2 (1 - d/D) with n = 9, d = 7.94 and D = 39.
TEST(LineOrders, AreThoseOfA6205) {
  const auto orders = line_orders({});
  EXPECT_NEAR(orders[0], 5.416154, 1e-6);
  EXPECT_NEAR(orders[1], 4.708249, 1e-6);
  EXPECT_NEAR(orders[2], 3.583846, 1e-6);
  EXPECT_NEAR(last_order(orders), 4 * 1.012 * 5.416154, 1e-5);
}

/// A spectrum that is `height` within 0.1 of each multiple of an order, and -0.7 elsewhere.
OrderSpectrum comb(double order, double height) {
  OrderSpectrum spectrum{Eigen::ArrayXd(460)};
  for (Eigen::Index i = 0; i < spectrum.heights.size(); ++i) {
    const double at = OrderSpectrum::first + OrderSpectrum::step * static_cast<double>(i);
    const double harmonic = std::max(1.0, std::round(at / order));
    spectrum.heights[i] = std::abs(at - harmonic * order) < 0.1 ? height : -0.7;
  }
  return spectrum;
}

TEST(LineHeight, FindsALineThatSlipsByUpTo12InAThousand) {
  for (const double slip : {-0.012, -0.005, 0.0, 0.008, 0.012}) {
    EXPECT_NEAR(line_height(comb(5 * (1 + slip), 2), 5, 4, -1), 2, 1e-9) << slip;
  }
}

// A line that slips by 5 % is sought 3.8 % too near to 0 at best, which is 0.19 for the first
// harmonic and more for the others.
TEST(LineHeight, DoesNotFindOneThatSlipsFarther) {
  EXPECT_NEAR(line_height(comb(5 * 1.05, 2), 5, 4, -1), -0.7, 1e-9);
  EXPECT_NEAR(line_height(comb(5 * 0.95, 2), 5, 1, -1), -0.7, 1e-9);
}

// Without a common slip all four harmonics would be found, each at one of its own.
TEST(LineHeight, TakesOneSlipForAllHarmonics) {
  OrderSpectrum spectrum = comb(5, -0.7);
  const auto raise = [&](double order) {
    spectrum.heights[std::lround((order - OrderSpectrum::first) / OrderSpectrum::step)] = 2;
  };
  raise(5.05);  // + 1 %
  raise(9.9);   // - 1 %
  EXPECT_NEAR(line_height(spectrum, 5, 2, -1), (2 - 0.7) / 2, 1e-9);
}

TEST(LineHeight, IsClipped) {
  EXPECT_NEAR(line_height(comb(5, 7), 5, 4, -1), 2.5, 1e-9);
  EXPECT_NEAR(line_height(comb(5, -0.7), 5, 4, -0.5), -0.5, 1e-9);
}

}  // namespace
}  // namespace piae::symptoms
