#include "run/selection.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace piae::run {
namespace {

TEST(Selection, KeepsScoresIfARatioHasGeneratedWindows) {
  const Combination score{"vae", "", ""};
  EXPECT_TRUE(Selection{}.has(score, 0));
  const Selection baseline{.ratios = {"100to1"}};
  EXPECT_FALSE(baseline.has(score, 0));
  EXPECT_TRUE(baseline.has({"none", "100to1"}, 0));
  EXPECT_FALSE(baseline.has({"vae", "10to1"}, 0));
  const Selection both{.ratios = {"100to1", "10to1"}};
  EXPECT_TRUE(both.has(score, 0));
  EXPECT_THROW((void)(Selection{.ratios = {"3to1"}}.has(score, 0)), Error);
}

TEST(Selection, ByClassifierAppliesOnlyToDiagnoses) {
  const Selection nearest{.classifiers = {"nearest"}};
  EXPECT_TRUE(nearest.has({"none", "100to1", "nearest"}, 0));
  EXPECT_FALSE(nearest.has({"none", "100to1", "wdcnn"}, 0));
  EXPECT_TRUE(nearest.has({"vae", "", ""}, 0));
}

}  // namespace
}  // namespace piae::run
