#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace piae {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  std::vector<int> visits(1000);
  parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));
}

TEST(ParallelFor, DoesNothingForNothing) {
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsTheErrorOfTheLowestIndexAfterAllEnd) {
  std::atomic<int> ended = 0;
  try {
    parallel_for(100, [&](std::size_t i) {
      ++ended;
      if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "7");
  }
  EXPECT_EQ(ended, 100);
}

TEST(ParallelForParts, CutsEachSetSeparately) {
  std::vector<int> set_of(21, -1);
  std::atomic<int> parts = 0;
  parallel_for_parts(3, 7, 3, [&](std::size_t first, std::size_t count) {
    ++parts;
    EXPECT_EQ(first / 7, (first + count - 1) / 7) << "within one set";
    EXPECT_TRUE(count == 3 || (count == 1 && first % 7 == 6));
    for (std::size_t i = first; i < first + count; ++i) set_of[i] = static_cast<int>(i / 7);
  });
  EXPECT_EQ(parts, 9);
  for (std::size_t i = 0; i < set_of.size(); ++i) EXPECT_EQ(set_of[i], static_cast<int>(i / 7));
}

TEST(ParallelForParts, DoesNothingForNothing) {
  parallel_for_parts(3, 0, 8, [](std::size_t, std::size_t) { FAIL(); });
  parallel_for_parts(0, 3, 8, [](std::size_t, std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace piae
