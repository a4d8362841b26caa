#include "scoring/recall.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/three_classes.hpp"

namespace piae::scoring {
namespace {

/// A row for each true class: 10 healthy windows, 20 of the inner race, 8 of the outer one.
const Confusion example{3, {7, 2, 1, 4, 15, 1, 0, 3, 5}};

TEST(Recall, IsTheShareOfAClassClassifiedCorrectly) {
  const Share inner = recall_of(example, 1);
  EXPECT_EQ(inner.count, 15);
  EXPECT_EQ(inner.of, 20);
  EXPECT_EQ(inner.percent(), 75);
  EXPECT_EQ(recall_of({2, {1, 1, 0, 0}}, 1).of, 0);
}

/// A fault predicted as another fault is not missed.
TEST(Recall, DistinguishesMissedFaultsFromFalseAlarms) {
  const auto classes = three_classes("cwru").classes;
  const Share missed = missed_faults(example, classes);
  EXPECT_EQ(missed.count, 4);
  EXPECT_EQ(missed.of, 28);
  const Share alarms = false_alarms(example, classes);
  EXPECT_EQ(alarms.count, 3);
  EXPECT_EQ(alarms.of, 10);
  EXPECT_EQ(alarms.percent(), 30);
}

TEST(Recall, ConfusionsOfTheSameClassesAddUp) {
  Confusion sum;
  add(sum, example);
  add(sum, {3, {1, 0, 0, 0, 2, 0, 0, 0, 3}});
  EXPECT_EQ(sum, (Confusion{3, {8, 2, 1, 4, 17, 1, 0, 3, 8}}));
  EXPECT_THROW(add(sum, {2, {1, 0, 0, 1}}), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring
