#include "base/range.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace piae {
namespace {

constexpr Range rate{.low = 1, .high = 1e7, .unit = " Hz"};

TEST(Range, IncludesItsEnds) {
  EXPECT_TRUE(rate.holds(1));
  EXPECT_TRUE(rate.holds(1e7));
  EXPECT_FALSE(rate.holds(0.999));
  EXPECT_FALSE(rate.holds(1.1e7));
}

TEST(Range, ExcludesNonFiniteValues) {
  EXPECT_FALSE(rate.holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(rate.holds(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(rate.holds(-std::numeric_limits<double>::infinity()));
}

TEST(Range, DescribesItself) { EXPECT_EQ(rate.rule(), "must be from 1 to 1e+07 Hz"); }

}  // namespace
}  // namespace piae
