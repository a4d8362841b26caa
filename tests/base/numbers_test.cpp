#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace piae {
namespace {

TEST(NumberIn, ParsesTheWholeTextOrNothing) {
  EXPECT_EQ(number_in<std::int64_t>("-12"), -12);
  EXPECT_EQ(number_in<double>("5e-4"), 5e-4);
  for (const std::string text : {"", " 1", "1 ", "1x", "x", "1,5", "0x10"}) {
    EXPECT_EQ(number_in<double>(text), std::nullopt) << text;
    EXPECT_EQ(number_in<std::int64_t>(text), std::nullopt) << text;
  }
  EXPECT_EQ(number_in<std::int64_t>("1.5"), std::nullopt);
}

TEST(NumberIn, RefusesNumbersOutsideTheType) {
  EXPECT_EQ(number_in<std::int64_t>("9223372036854775807"), INT64_MAX);
  EXPECT_EQ(number_in<std::int64_t>("9223372036854775808"), std::nullopt);
  EXPECT_EQ(number_in<double>("1e999"), std::nullopt);
}

TEST(FirstBeyond32Bits, FindsNanInfiniteAndTooLarge) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(first_beyond_32_bits(std::vector<double>{0, -3e38, 3e38}), std::nullopt);
  EXPECT_EQ(first_beyond_32_bits(std::vector<double>{0, 4e38}), 1U);
  EXPECT_EQ(first_beyond_32_bits(std::vector<double>{0, 0, nan, 1e300}), 2U);
}

}  // namespace
}  // namespace piae
