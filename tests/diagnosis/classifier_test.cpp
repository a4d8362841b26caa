#include "diagnosis/classifier.hpp"

#include <gtest/gtest.h>

namespace piae::diagnosis {
namespace {

TEST(MostLikely, IsTheFirstClassWithTheHighestScore) {
  const std::vector<float> scores{0.1F, 0.7F, 0.2F, 0.4F, 0.2F, 0.4F, 0, 0, 1};
  EXPECT_EQ(most_likely(scores, 3), (std::vector<Label>{1, 0, 2}));
  EXPECT_TRUE(most_likely({}, 3).empty());
}

}  // namespace
}  // namespace piae::diagnosis
