#include "trend/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace piae::trend {
namespace {

TrendPoint point_at(double time_s, double level_db) {
  TrendPoint point{.time_s = time_s, .windows = 1, .evidence = level_db / 10};
  point.rises = {.level_db = level_db, .watched_db = Eigen::ArrayXd::Constant(7, level_db)};
  return point;
}

TEST(History, MergesNeighboursWhenThereAreTooMany) {
  History history(4);
  for (int i = 1; i <= 4; ++i) history.add(point_at(i, i));
  ASSERT_EQ(history.points().size(), 2U);
  EXPECT_EQ(history.points()[0].time_s, 2);
  EXPECT_EQ(history.points()[0].windows, 2U);
  EXPECT_EQ(history.points()[0].rises->level_db, 1.5);
  EXPECT_EQ(history.points()[0].rises->watched_db[3], 1.5);
  EXPECT_EQ(history.points()[0].evidence, 0.2);
  EXPECT_EQ(history.points()[1].rises->level_db, 3.5);
}

TEST(History, KeepsAlarmsAndStaysSmall) {
  History history(100);
  for (int i = 0; i < 100000; ++i) {
    TrendPoint point = point_at(i, 1);
    if (i == 777) point.alarm = monitor::AlarmState::raised;
    history.add(point);
  }
  EXPECT_LT(history.points().size(), 100U);
  const auto raised =
      std::ranges::find(history.points(), monitor::AlarmState::raised, &TrendPoint::alarm);
  ASSERT_NE(raised, history.points().end());
  EXPECT_EQ(raised->time_s, 777);
  EXPECT_EQ(history.points().back().time_s, 99999);
}

TEST(History, MergesPointsWithoutASignal) {
  History history(2);
  history.add(point_at(1, 5));
  TrendPoint silent = point_at(2, 0);
  silent.rises.reset();
  history.add(silent);
  ASSERT_EQ(history.points().size(), 1U);
  EXPECT_EQ(history.points()[0].rises->level_db, 5);
}

}  // namespace
}  // namespace piae::trend
