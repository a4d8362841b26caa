#include "cli/checks.hpp"

#include <gtest/gtest.h>

namespace piae::cli {
namespace {

bool accepts(const Check& check, const std::string& text) { return check.refusal(text).empty(); }

TEST(Checks, AcceptTheirRange) {
  EXPECT_TRUE(accepts(positive_number(), "5e-4"));
  EXPECT_FALSE(accepts(positive_number(), "0"));
  EXPECT_FALSE(accepts(positive_number(), "-1"));
  EXPECT_TRUE(accepts(non_negative_number(), "0"));
  EXPECT_FALSE(accepts(non_negative_number(), "-0.1"));
  EXPECT_TRUE(accepts(share(), "1"));
  EXPECT_FALSE(accepts(share(), "1.01"));
  EXPECT_TRUE(accepts(natural_number(), "0"));
  EXPECT_FALSE(accepts(natural_number(), "-1"));
  EXPECT_FALSE(accepts(natural_number(), "1.5"));
  EXPECT_FALSE(accepts(natural_number(), "99999999999999999999"));
  EXPECT_TRUE(accepts(whole_number(2, 32), "2"));
  EXPECT_TRUE(accepts(whole_number(2, 32), "32"));
  EXPECT_FALSE(accepts(whole_number(2, 32), "1"));
  EXPECT_FALSE(accepts(whole_number(2, 32), "33"));
  EXPECT_FALSE(accepts(whole_number(2, 32), "2.5"));
  EXPECT_TRUE(accepts(one_of({"best", "final"}), "final"));
  EXPECT_FALSE(accepts(one_of({"best", "final"}), "Final"));
}

TEST(Checks, RefuseNonFiniteNumbers) {
  for (const std::string text : {"nan", "inf", "-inf", "many", "", "1e999", "1 ", "1,5", "0x10"}) {
    for (const Check& check : {positive_number(), non_negative_number(), share(), natural_number(),
                               whole_number(-100, 100)}) {
      EXPECT_FALSE(accepts(check, text)) << text;
    }
  }
}

TEST(Checks, DescribeTheirRange) {
  EXPECT_EQ(within({.low = 0, .high = 60, .unit = " dB"}).refusal("61"),
            "'61' is not a number from 0 to 60 dB");
  EXPECT_EQ(positive_number().refusal("-1"), "'-1' is not a positive number");
  EXPECT_EQ(whole_number(1, 32).refusal("40"), "'40' is not a whole number from 1 to 32");
  EXPECT_EQ(one_of({"best", "final"}).refusal("worst"), "'worst' is not one of: best, final");
}

}  // namespace
}  // namespace piae::cli
