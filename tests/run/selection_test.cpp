#include "run/selection.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace piae::run {
namespace {

TEST(Selection, ScoresGoWithRatiosThatHaveGeneratedWindows) {
  EXPECT_TRUE(Selection{}.has("vae", "", 0));
  const Selection baseline{.ratios = {"100to1"}};
  EXPECT_FALSE(baseline.has("vae", "", 0));
  EXPECT_TRUE(baseline.has("none", "100to1", 0));
  EXPECT_FALSE(baseline.has("vae", "10to1", 0));
  const Selection both{.ratios = {"100to1", "10to1"}};
  EXPECT_TRUE(both.has("vae", "", 0));
  EXPECT_THROW((void)(Selection{.ratios = {"3to1"}}.has("vae", "", 0)), Error);
}

}  // namespace
}  // namespace piae::run
