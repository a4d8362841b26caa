#include "augment/starting_windows.hpp"

#include "augment/places.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

using Counts = std::vector<std::int64_t>;
using Turns = std::vector<std::size_t>;

TEST(ForeignNeighbours, MatchTheHandWorkedTable) {
  // The three nearest windows of each known one, by their places:
  //   IR  0: 1 3 4     IR  1: 0 3 4     IR  3: 4 1 5     IR  9: 10 11 5
  //   OR  4: 3 5 1     OR 10: 9 11 5
  EXPECT_EQ(foreign_neighbours(known_at_places(), healthy_at_places(), 3),
            (Counts{1, 1, 2, 3, 3, 3}));
  // All other seven: a window of IR has three of its own class among them, a window of OR one.
  EXPECT_EQ(foreign_neighbours(known_at_places(), healthy_at_places(), 7),
            (Counts{4, 4, 4, 4, 6, 6}));
}

TEST(ForeignNeighbours, TakeKnownWindowsFirstAtEqualDistances) {
  const signal::WindowSet known = at_places({{1, 0}, {1, 2}, {2, 50}, {2, 60}});
  const signal::WindowSet healthy = at_places({{0, -2}, {0, 40}});
  EXPECT_EQ(foreign_neighbours(known, healthy, 1), (Counts{0, 0, 0, 0}));
  EXPECT_EQ(foreign_neighbours(known, healthy, 2), (Counts{1, 1, 1, 1}));
}

TEST(ForeignNeighbours, CannotBeCountedAmongMoreWindowsThanThereAre) {
  EXPECT_ERROR(foreign_neighbours(known_at_places(), healthy_at_places(), 8), Exit::usage,
               "--foreign-among 8: there are 8 real windows; give at most --foreign-among 7");
}

TEST(EvenTurns, MatchTheHandWorkedOrder) {
  // Lags before each turn, in sevenths:
  //   1 1 2 3   2 2 4 -1   3 3 -1 2   -3 4 1 5   -2 5 3 1   -1 -1 5 4   0 0 0 7
  EXPECT_EQ(even_turns(Counts{1, 1, 2, 3}, 9), (Turns{3, 2, 0, 3, 1, 2, 3, 3, 2}));
}

TEST(EvenTurns, OfEqualWeightsFollowTheOrderOfTheWindows) {
  EXPECT_EQ(even_turns(Counts{4, 4, 4}, 7), (Turns{0, 1, 2, 0, 1, 2, 0}));
}

TEST(EvenTurns, LeaveOutWindowsWithoutWeight) {
  EXPECT_EQ(even_turns(Counts{0, 1, 0, 1}, 5), (Turns{1, 3, 1, 3, 1}));
  EXPECT_EQ(even_turns(Counts{0, 5}, 2), (Turns{1, 1}));
}

}  // namespace
}  // namespace piae::augment
