#include "twin/batches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace piae::twin {
namespace {

using testing::SizeIs;
using testing::UnorderedElementsAre;

const std::vector<Label> labels{1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3};

std::vector<std::vector<std::size_t>> batches(Batches kind, std::size_t size,
                                              const std::string& epoch = "epoch") {
  Stream shuffle(epoch);
  return batches_of_an_epoch(labels, kind, size, shuffle);
}

std::vector<std::size_t> all_of(const std::vector<std::vector<std::size_t>>& parts) {
  std::vector<std::size_t> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(Batches, HoldEachKnownWindowOnce) {
  for (const Batches kind : {Batches::mixed, Batches::of_one_class}) {
    for (const std::size_t size : {1, 2, 5, 100}) {
      EXPECT_THAT(all_of(batches(kind, size)),
                  UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
    }
  }
}

TEST(Batches, MixedBatchesAreFullExceptTheLast) {
  EXPECT_THAT(batches(Batches::mixed, 4), testing::ElementsAre(SizeIs(4), SizeIs(4), SizeIs(3)));
}

TEST(Batches, OneClassBatchHoldsTheWholeClassIfItFits) {
  const auto parts = batches(Batches::of_one_class, 5);
  EXPECT_THAT(parts, UnorderedElementsAre(UnorderedElementsAre(0, 1, 2),
                                          UnorderedElementsAre(3, 4, 5, 6, 7),
                                          UnorderedElementsAre(8, 9, 10)));
  for (const auto& part : batches(Batches::of_one_class, 2)) {
    std::set<Label> classes;
    for (const std::size_t i : part) classes.insert(labels[i]);
    EXPECT_THAT(classes, SizeIs(1));
  }
}

/// Classes have 3, 5 and 3 windows; a batch of eight holds any two of them.
TEST(Batches, HoldTheLargestPossibleNumberOfWholeClasses) {
  for (int epoch = 0; epoch < 20; ++epoch) {
    const auto parts = batches(Batches::of_one_class, 8, std::to_string(epoch));
    EXPECT_THAT(parts, SizeIs(2));
    for (const auto& part : parts) {
      for (const Label label : {1, 2, 3}) {
        const auto of_label =
            std::ranges::count_if(part, [&](std::size_t i) { return labels[i] == label; });
        EXPECT_TRUE(of_label == 0 || of_label == std::ranges::count(labels, label));
      }
    }
  }
  EXPECT_THAT(batches(Batches::of_one_class, 100), SizeIs(1));
}

TEST(Batches, AreShuffledInEachEpoch) {
  std::set<std::vector<std::vector<std::size_t>>> orders;
  for (int epoch = 0; epoch < 20; ++epoch) {
    orders.insert(batches(Batches::of_one_class, 5, std::to_string(epoch)));
  }
  EXPECT_GT(orders.size(), 10U);
}

}  // namespace
}  // namespace piae::twin
