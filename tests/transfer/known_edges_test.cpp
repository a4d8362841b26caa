#include "transfer/known_edges.hpp"

#include <gtest/gtest.h>

#include "transfer/bearings.hpp"
#include "transfer/carried.hpp"

namespace piae::transfer {
namespace {

TEST(KnownEdges, AreFoundInWindowsOfOneMachine) {
  const signal::WindowSet known = one_machine();
  const std::vector<Edges> edges = edges_of_known(known, {});
  ASSERT_EQ(edges.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double share = edges[i].lag_s / passage_s(known, i, known.size_mm(i), 1200);
    EXPECT_NEAR(share, lag_shares[i / 5], 0.035) << i;
    EXPECT_NEAR(edges[i].exit, 0.6, 0.26) << i;
    EXPECT_EQ(edges[i].lag_s, edges[i / 5 * 5].lag_s) << "windows of one bearing";
  }
}

TEST(Bearings, AreTheWindowsOfOneClassSpeedAndSize) {
  signal::WindowSet known = one_machine();
  known.shaft_speed_rpm[3] = 900;
  known.defect_size_mm.assign(20, 1.0);
  known.defect_size_mm[7] = 0.5;
  const std::vector<KnownBearing> bearings = bearings_of(known);
  ASSERT_EQ(bearings.size(), 6U);
  EXPECT_EQ(bearings[0].windows, (std::vector<std::size_t>{3}));
  EXPECT_EQ(bearings[0].speed_rpm, 900);
  EXPECT_EQ(bearings[1].windows, (std::vector<std::size_t>{0, 1, 2, 4}));
  EXPECT_EQ(bearings[2].windows, (std::vector<std::size_t>{7}));
  EXPECT_EQ(bearings[2].size_mm, 0.5);
}

}  // namespace
}  // namespace piae::transfer
