#include "scoring/type_accuracy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace piae::scoring {
namespace {

using signal::Defect;

/// Two sizes of an inner race defect, one of a ball defect.
const std::vector<signal::ClassInfo> two_sizes{{"Normal", Defect::none, 0},
                                               {"IR007", Defect::inner, 0.2},
                                               {"IR021", Defect::inner, 0.5},
                                               {"B007", Defect::roller, 0.2}};

// Of 20 windows 10 are classified correctly, 4 as the other size, and 6 as another fault type.
TEST(TypeAccuracy, IgnoresTheDefectSize) {
  const Confusion confusion{4,
                            {5, 0, 0, 0,  //
                             0, 2, 3, 0,  //
                             1, 1, 1, 2,  //
                             2, 0, 1, 2}};
  EXPECT_EQ(accuracy(confusion), 0.5);
  EXPECT_EQ(type_accuracy(confusion, two_sizes), 0.7);
}

TEST(TypeAccuracy, IsTheAccuracyIfEachFaultTypeIsOneClass) {
  const std::vector<signal::ClassInfo> classes{
      {"Normal", Defect::none, 0}, {"IR", Defect::inner, 0.2}, {"OR", Defect::outer, 0.2}};
  const Confusion confusion{3, {4, 1, 0, 2, 3, 0, 1, 0, 9}};
  EXPECT_EQ(type_accuracy(confusion, classes), accuracy(confusion));
}

TEST(TypeAccuracy, NeedsTheDefectOfEachClassAndAWindow) {
  EXPECT_THROW(type_accuracy({3, std::vector<std::int64_t>(9, 1)}, two_sizes), std::logic_error);
  EXPECT_THROW(type_accuracy({4, std::vector<std::int64_t>(16)}, two_sizes), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring
