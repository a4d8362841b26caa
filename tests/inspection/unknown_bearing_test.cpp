#include "inspection/unknown_bearing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace piae::inspection {
namespace {

using Eigen::ArrayXd;
using signal::BearingLines;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double thirty_hz = 30;

/// SKF 6205, worked by hand from 9 balls of 7.94 mm on 39.04 mm: d / D = 0.2034.
constexpr double bpfo = 3.585;
constexpr double bpfi = 5.415;
constexpr double twice_bsf = 4.714;
constexpr double cage = 0.3983;
const std::vector<BearingLines> known{{"6205", bpfo, bpfi, twice_bsf}, {"other", 2.9, 5.1, {}}};

/// Lines of a fault, by hundredths of an order.
class Lines {
 public:
  /// Adds harmonics of an order up to 68, and side bands at these distances, by so many dB below
  /// them.
  Lines& add(double order, double db, const std::vector<double>& distances = {}, double depth = 0,
             int most = 200) {
    for (int h = 1; h <= most && h * order < 68; ++h) {
      put(h * order, db);
      for (const double distance : distances) {
        put(h * order - distance, db - depth);
        put(h * order + distance, db - depth);
      }
    }
    return *this;
  }
  [[nodiscard]] UnknownLine named(bool speed_is_certain = true,
                                  std::span<const BearingLines> bearings = known) const {
    return unknown_line({lines_, ArrayXd::Zero(7000), thirty_hz}, speed_is_certain, bearings);
  }

 private:
  void put(double order, double db) {
    double& line = lines_[std::lround(order * 100)];
    line = std::max(line, db);
  }
  ArrayXd lines_ = ArrayXd::Zero(7000);
};

void expect(const UnknownLine& line, Likeness likeness, double order, bool is_certain) {
  EXPECT_EQ(line.likeness, likeness);
  EXPECT_NEAR(line.order, order, 0.005 * order);
  EXPECT_EQ(line.is_certain, is_certain);
}

TEST(UnknownBearing, AnOuterRaceHasNoSideBands) {
  const UnknownLine line = Lines().add(bpfo, 25).named();
  expect(line, Likeness::outer, bpfo, true);
  EXPECT_NEAR(line.db, 25, 0.1);
  EXPECT_THAT(line.bearings, ElementsAre("6205"));
}

TEST(UnknownBearing, AnInnerRaceHasSideBandsOfTheShaft) {
  expect(Lines().add(bpfi, 25, {1, 2}, 3).named(), Likeness::inner, bpfi, true);
  // Medium side bands suit a worn outer race, too.
  expect(Lines().add(bpfi, 25, {1}, 8).named(), Likeness::outer_or_inner, bpfi, false);
}

/// Below 4 orders no bearing of seven balls has its BPFI, but the doubt remains.
TEST(UnknownBearing, AnOuterRaceMayHaveSideBandsOfTheShaft) {
  expect(Lines().add(bpfo, 25, {1, 2}, 1).named(), Likeness::outer, bpfo, false);
}

TEST(UnknownBearing, ABallHasSideBandsOfTheCage) {
  expect(Lines().add(twice_bsf, 25, {cage}, 3).named(), Likeness::ball, twice_bsf, true);
  // Hits on one race only: a line at BSF.
  expect(Lines().add(twice_bsf / 2, 25, {cage}, 3).named(), Likeness::ball, twice_bsf, true);
}

TEST(UnknownBearing, ACageIsNeverCertain) {
  const UnknownLine line = Lines().add(cage, 25).named();
  expect(line, Likeness::cage, cage, false);
  EXPECT_THAT(line.bearings, IsEmpty());
}

TEST(UnknownBearing, CannotBeNamedWithoutAStrongLine) {
  const UnknownLine faint = Lines().add(bpfo, 7).named();
  EXPECT_EQ(faint.likeness, Likeness::nothing);
  EXPECT_EQ(faint.order, 0);
  EXPECT_NEAR(faint.db, 7, 0.1);
  EXPECT_EQ(Lines().named().likeness, Likeness::nothing);
}

/// Unbalance, misalignment and looseness: multiples of the shaft's speed and of its half.
TEST(UnknownBearing, HarmonicsOfTheShaftAreNotNamed) {
  for (const double order : {0.5, 1.0, 2.0, 3.0, 2.5}) {
    EXPECT_EQ(Lines().add(order, 30).named().likeness, Likeness::nothing) << order;
  }
}

/// 50 Hz are 1.667 and 100 Hz 3.333 orders of 30 Hz; up to 400 Hz.
TEST(UnknownBearing, MainsIsNotNamed) {
  EXPECT_EQ(Lines().add(50.0 / 30, 30, {}, 0, 8).named().likeness, Likeness::nothing);
  EXPECT_EQ(Lines().add(100.0 / 30, 30, {}, 0, 4).named().likeness, Likeness::nothing);
}

TEST(UnknownBearing, IsCertainOnlyWithASpeedAndAKnownBearing) {
  const Lines lines = Lines().add(bpfo, 25);
  expect(lines.named(false), Likeness::outer, bpfo, false);
  expect(lines.named(true, {}), Likeness::outer, bpfo, false);
  expect(Lines().add(bpfo, 15).named(), Likeness::outer, bpfo, false);
  const std::vector<BearingLines> twelve_balls{{"6205", bpfo, bpfi, twice_bsf},
                                               {"twelve", bpfi, 6.6, {}}};
  expect(Lines().add(bpfi, 25, {1, 2}, 3).named(true, twelve_balls), Likeness::inner, bpfi, false);
}

}  // namespace
}  // namespace piae::inspection
