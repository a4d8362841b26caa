#include "augment/interpolation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace piae::augment {
namespace {

using Indices = std::vector<std::size_t>;

// Four windows of two samples. Squared distances, by hand:
//        a   b   c   d
//   a    .   4   9  25
//   b    4   .  13  13
//   c    9  13   .  16
//   d   25  13  16   .
const std::vector<float> a{0, 0};
const std::vector<float> b{2, 0};
const std::vector<float> c{0, 3};
const std::vector<float> d{4, 3};
const std::vector<Window> windows{a, b, c, d};

TEST(NearestNeighbours, MatchTheHandWorkedTable) {
  // b is equally far from c and d: the earlier comes first.
  EXPECT_EQ(nearest_neighbours(windows, 1), (std::vector<Indices>{{1}, {0}, {0}, {1}}));
  EXPECT_EQ(nearest_neighbours(windows, 2), (std::vector<Indices>{{1, 2}, {0, 2}, {0, 1}, {1, 2}}));
  EXPECT_EQ(nearest_neighbours(windows, 3),
            (std::vector<Indices>{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {1, 2, 0}}));
}

TEST(NearestNeighbours, ExcludeTheWindowItself) {
  EXPECT_EQ(nearest_neighbours({a, a, a}, 2), (std::vector<Indices>{{1, 2}, {0, 2}, {0, 1}}));
}

TEST(NearestNeighbours, CannotExceedTheNumberOfOtherWindows) {
  EXPECT_THROW(nearest_neighbours(windows, 4), std::logic_error);
  EXPECT_THROW(nearest_neighbours({}, 0), std::logic_error);
}

TEST(NearestNeighbours, NeedWindowsOfOneLength) {
  const std::vector<float> longer{1, 2, 3};
  EXPECT_THROW(nearest_neighbours({a, longer}, 1), std::logic_error);
}

TEST(Interpolate, MatchesTheHandWorkedPoint) {
  const std::vector<float> base{1, -2, 8};
  const std::vector<float> neighbour{3, -2, 0};
  EXPECT_EQ(interpolate(base, neighbour, 0), base);
  EXPECT_EQ(interpolate(base, neighbour, 1), neighbour);
  EXPECT_EQ(interpolate(base, neighbour, 0.25), (std::vector<float>{1.5F, -2, 6}));
  EXPECT_EQ(interpolate(base, neighbour, 0.75), (std::vector<float>{2.5F, -2, 2}));
}

}  // namespace
}  // namespace piae::augment
