#include "scoring/accuracy.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

using testing::ElementsAre;

TEST(Confusion, HasTrueClassesInRowsAndPredictedOnesInColumns) {
  const std::vector<std::int32_t> labels{0, 0, 0, 1, 1, 2};
  const std::vector<std::int32_t> predictions{0, 1, 1, 1, 0, 2};
  const Confusion confusion = confusion_matrix(labels, predictions, 3);
  EXPECT_THAT(confusion.counts, ElementsAre(1, 2, 0, 1, 1, 0, 0, 0, 1));
  EXPECT_EQ(confusion.at(0, 1), 2);
  EXPECT_EQ(confusion.at(1, 0), 1);
}

TEST(Accuracy, IsTheShareOnTheDiagonal) {
  EXPECT_EQ(accuracy({2, {1, 3, 0, 4}}), 5.0 / 8.0);
  EXPECT_EQ(accuracy({2, {0, 3, 4, 0}}), 0.0);
  EXPECT_EQ(accuracy({2, {3, 0, 0, 4}}), 1.0);
}

TEST(Accuracy, NeedsAWindow) { EXPECT_THROW(accuracy({2, {0, 0, 0, 0}}), std::logic_error); }

TEST(Confusion, RefusesMismatchedSizes) {
  const std::vector<std::int32_t> two{0, 1};
  EXPECT_THROW(confusion_matrix(two, std::vector<std::int32_t>{0}, 2), std::logic_error);
  EXPECT_THROW(confusion_matrix(two, std::vector<std::int32_t>{0, 2}, 2), std::logic_error);
  EXPECT_THROW(confusion_matrix(two, std::vector<std::int32_t>{-1, 0}, 2), std::logic_error);
}

/// Three of four correct in one class, none in another; the third has no windows.
TEST(BalancedAccuracy, IsTheMeanOverClassesWithWindows) {
  const Confusion confusion =
      confusion_matrix(std::vector<Label>{0, 0, 0, 0, 2}, std::vector<Label>{0, 0, 0, 1, 0}, 3);
  EXPECT_DOUBLE_EQ(balanced_accuracy(confusion), (0.75 + 0) / 2);
  EXPECT_DOUBLE_EQ(accuracy(confusion), 0.6);
  EXPECT_THROW(balanced_accuracy({2, std::vector<std::int64_t>(4)}), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring
