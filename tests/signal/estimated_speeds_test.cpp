#include "signal/estimated_speeds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/turning_shaft.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;

/// Four records of a nominal 1200 rpm: two turn at other speeds, one does not show its speed, and
/// one belongs to another condition.
class NominalSpeeds : public testing::Test {
 protected:
  NominalSpeeds() {
    const auto write = [&](const std::string& name, const std::vector<double>& samples) {
      folder_.write(name, column_of(samples));
    };
    write("a.csv", turning_shaft(1160, 40000, 4000, 1));
    write("b.csv", turning_shaft(1272, 40000, 4000, 2));
    write("c.csv", turning_shaft(1272, 300, 4000, 3));
    write("d.csv", turning_shaft(790, 40000, 4000, 4));
    description_.info.name = "rig";
    description_.info.sample_rate_hz = 4000;
    description_.info.classes = {{"ok", Defect::none, 0}};
    description_.info.conditions = {{.name = "fast", .shaft_speed_rpm = 1200},
                                    {.name = "slow", .shaft_speed_rpm = 800}};
    for (const std::string name : {"a", "b", "c", "d"}) {
      const bool slow = name == "d";
      description_.records.push_back({.name = name,
                                      .label = 0,
                                      .files = {name + ".csv"},
                                      .variable = "1",
                                      .sample_rate_hz = 4000,
                                      .shaft_speed_rpm = slow ? 800.0 : 1200.0,
                                      .sha256 = "",
                                      .url = "",
                                      .condition = slow ? "slow" : "fast"});
    }
  }
  [[nodiscard]] std::vector<double> speeds() const {
    std::vector<double> all;
    for (const RecordSource& source : description_.records)
      all.push_back(std::round(source.shaft_speed_rpm));
    return all;
  }
  const Folder folder_;
  Description description_;
};

TEST_F(NominalSpeeds, CountIfNoSearchIsDescribed) {
  const EstimatedSpeeds found = use_speeds_of_signals(description_, "no folder", [] { FAIL(); });
  EXPECT_EQ(found.found, 0U);
  EXPECT_THAT(speeds(), ElementsAre(1200, 1200, 1200, 800));
}

TEST_F(NominalSpeeds, AreReplacedWhereTheShaftShows) {
  description_.speed_search_percent = 10;
  int done = 0;
  const EstimatedSpeeds found =
      use_speeds_of_signals(description_, folder_.path(), [&] { ++done; });
  EXPECT_EQ(done, 4);
  EXPECT_EQ(found.found, 3U);
  EXPECT_NEAR(found.lowest, 1160.0 / 1200, 1e-3);
  EXPECT_NEAR(found.highest, 1272.0 / 1200, 1e-3);
  EXPECT_THAT(speeds(), ElementsAre(1160, 1272, 1200, 790));
  EXPECT_NEAR(description_.info.conditions[0].shaft_speed_rpm, (1160 + 1272 + 1200) / 3.0, 1);
  EXPECT_NEAR(description_.info.conditions[1].shaft_speed_rpm, 790, 1);
}

TEST_F(NominalSpeeds, AreNotReplacedBeyondTheSearch) {
  description_.speed_search_percent = 2;
  (void)use_speeds_of_signals(description_, folder_.path(), [] {});
  EXPECT_EQ(speeds()[0], 1200);
  EXPECT_EQ(speeds()[3], 790);
}

/// The shaft of b seems to turn at 1272 rpm, but its pulses, which count, say 1200.
TEST_F(NominalSpeeds, AreNotThoseOfTheSignalWhereTheSpeedWasRecorded) {
  std::string pulses;
  for (int i = 0; i <= 200; ++i) pulses += std::to_string(0.05 * i) + '\n';
  folder_.write("b-pulses.csv", pulses);
  description_.records[1].speed = SpeedSource{.file = "b-pulses.csv", .variable = "1"};
  description_.records[1].shaft_speed_rpm = 1;
  int done = 0;
  EXPECT_EQ(use_speeds_of_signals(description_, folder_.path(), [&] { ++done; }).found, 0U);
  EXPECT_EQ(done, 1);
  EXPECT_THAT(speeds(), ElementsAre(1200, 1200, 1200, 800));
  EXPECT_NEAR(description_.info.conditions[0].shaft_speed_rpm, 1200, 0.01);
  description_.speed_search_percent = 10;
  EXPECT_EQ(use_speeds_of_signals(description_, folder_.path(), [] {}).found, 2U);
  EXPECT_THAT(speeds(), ElementsAre(1160, 1200, 1200, 790));
}

TEST(LongestPiece, IsThatOfMostSamples) {
  const std::vector<double> signal{1, 2, 3, 4, 5, 6};
  const auto piece = longest_piece(signal, {1, 3, 2});
  EXPECT_THAT(std::vector<double>(piece.begin(), piece.end()), ElementsAre(2, 3, 4));
}

}  // namespace
}  // namespace piae::signal
