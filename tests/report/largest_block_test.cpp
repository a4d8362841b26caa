#include <gmock/gmock.h>

#include "report/ratio_means.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LargestBlock, IsTheWholeTableIfNothingIsMissing) {
  const Block block = largest_block({{0, 1, 2}, {0, 1, 2}}, 1, 1);
  EXPECT_THAT(block.rows, ElementsAre(0, 1));
  EXPECT_THAT(block.columns, ElementsAre(0, 1, 2));
}

TEST(LargestBlock, LeavesOutASparseRow) {
  const Block block = largest_block({{0, 1, 2}, {1}, {0, 1, 2}}, 1, 1);
  EXPECT_THAT(block.rows, ElementsAre(0, 2));
  EXPECT_THAT(block.columns, ElementsAre(0, 1, 2));
}

TEST(LargestBlock, LeavesOutASparseColumn) {
  const Block block = largest_block({{0, 1, 2}, {0, 1}, {0, 1}}, 1, 1);
  EXPECT_THAT(block.rows, ElementsAre(0, 1, 2));
  EXPECT_THAT(block.columns, ElementsAre(0, 1));
}

TEST(LargestBlock, HasTheRequestedRowsAndColumns) {
  const std::vector<std::vector<std::size_t>> has{{0, 1, 2, 3}, {1}, {1}};
  EXPECT_THAT(largest_block(has, 1, 1).rows, ElementsAre(0));
  EXPECT_THAT(largest_block(has, 2, 1).rows, ElementsAre(0, 1, 2));
  EXPECT_THAT(largest_block(has, 2, 2).rows, IsEmpty());
  EXPECT_THAT(largest_block({}, 1, 1).rows, IsEmpty());
  EXPECT_THAT(largest_block({{}, {}}, 1, 1).rows, IsEmpty());
}

}  // namespace
}  // namespace piae::report
