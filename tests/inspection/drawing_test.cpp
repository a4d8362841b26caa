#include "inspection/drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace piae::inspection {
namespace {

TEST(Axis, IsStraight) {
  const Axis down{.low = -10, .high = 30, .from = 200, .to = 100};
  EXPECT_DOUBLE_EQ(down.at(-10), 200);
  EXPECT_DOUBLE_EQ(down.at(0), 175);
  EXPECT_DOUBLE_EQ(down.at(30), 100);
}

TEST(TickStep, MakesFourToTenStepsOfOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(tick_step(20), 5);
  EXPECT_DOUBLE_EQ(tick_step(19), 2);
  EXPECT_DOUBLE_EQ(tick_step(8), 2);
  EXPECT_DOUBLE_EQ(tick_step(7.9), 1);
  EXPECT_DOUBLE_EQ(tick_step(0.3), 0.05);
  EXPECT_DOUBLE_EQ(tick_step(568), 100);
}

// Two pixels, five values each: the lowest and the highest of each, in time order. The last value
// alone is on a further pixel and gives one point.
TEST(TraceOf, IsTheLowestAndHighestOnEachPixel) {
  const Axis x{.low = 0, .high = 10, .from = 100, .to = 102};
  const Axis y{.low = 0, .high = 1, .from = 0, .to = 1};
  const std::vector<Point> trace = trace_of({3, 1, 4, 9, 5, 8, 7, 6, 2, 5, 5}, 1, x, y);
  std::vector<std::pair<double, double>> points;
  for (const Point& point : trace) points.emplace_back(point.x, point.y);
  EXPECT_THAT(points, testing::ElementsAre(std::pair(100.0, 1.0), std::pair(100.0, 9.0),
                                           std::pair(101.0, 8.0), std::pair(101.0, 2.0),
                                           std::pair(102.0, 5.0)));
}

}  // namespace
}  // namespace piae::inspection
