#include "diagnosis/batches.hpp"

#include <gtest/gtest.h>

namespace piae::diagnosis {
namespace {

using Bounds = std::vector<std::int64_t>;

TEST(BatchBounds, CoverAllWindows) {
  EXPECT_EQ(batch_bounds(96, 32), (Bounds{0, 32, 64, 96}));
  EXPECT_EQ(batch_bounds(98, 32), (Bounds{0, 32, 64, 96, 98}));
  EXPECT_EQ(batch_bounds(10, 32), (Bounds{0, 10}));
}

TEST(BatchBounds, NoBatchHasOnlyOneWindow) {
  EXPECT_EQ(batch_bounds(97, 32), (Bounds{0, 32, 64, 97}));
  EXPECT_EQ(batch_bounds(545, 32).size(), 18U);  // 500 + 45 windows: the last of 17 batches has 33
  EXPECT_EQ(batch_bounds(2, 2), (Bounds{0, 2}));
  EXPECT_EQ(batch_bounds(3, 2), (Bounds{0, 3}));
}

}  // namespace
}  // namespace piae::diagnosis
