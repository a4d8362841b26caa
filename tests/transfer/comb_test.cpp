#include "transfer/comb.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "transfer/ringing.hpp"

namespace piae::transfer {
namespace {

TEST(Comb, AlignsWithTheStartOfEachRinging) {
  for (const double first : {3.0, 60.0, 150.0}) {
    const Comb comb = find_comb(ringing(first, 167.3, 1024), 167.3);
    EXPECT_NEAR(comb.period, 167.3, 1.0) << first;
    EXPECT_NEAR(comb.first - first, 6, 6) << first;
  }
}

TEST(Comb, FollowsBallsThatSlip) {
  EXPECT_NEAR(find_comb(ringing(20, 167.3 * 1.01, 1024), 167.3).period, 167.3 * 1.01, 0.6);
  EXPECT_NEAR(find_comb(ringing(20, 167.3 * 0.99, 1024), 167.3).period, 167.3 * 0.99, 0.6);
}

TEST(Comb, IsFoundInNoiseOfEqualRms) {
  Stream random("noise");
  for (int i = 0; i < 20; ++i) {
    const double first = random.uniform(0, 167);
    std::vector<double> window = ringing(first, 167.3, 1024);
    for (double& x : window) x += random.normal(0, 0.2);  // RMS of the ringing: 0.15
    const double off = std::remainder(find_comb(window, 167.3).first - first - 6, 167.3);
    EXPECT_NEAR(off, 0, 16) << i;
  }
}

TEST(Comb, ImpactsAreWholeSamplesWithinTheWindow) {
  EXPECT_EQ((Comb{.first = 1.5, .period = 2.6}.impact_positions(8)),
            (std::vector<std::size_t>{1, 4, 6}));
  EXPECT_TRUE((Comb{.first = 9, .period = 20}.impact_positions(8)).empty());
}

}  // namespace
}  // namespace piae::transfer
