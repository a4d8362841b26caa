#include "cli/numbers.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace piae::cli {
namespace {

bool accepts(const CLI::Validator& check, std::string text) { return check(text).empty(); }

TEST(Numbers, AcceptWhatTheySay) {
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
}

TEST(Numbers, RefuseWhatIsNotAFiniteNumber) {
  for (const std::string text : {"nan", "inf", "-inf", "many", ""}) {
    for (const CLI::Validator& check :
         {positive_number(), non_negative_number(), share(), natural_number()}) {
      EXPECT_FALSE(accepts(check, text)) << text;
    }
  }
}

TEST(Numbers, SayWhatWouldDo) {
  std::string text = "-1";
  EXPECT_EQ(positive_number()(text), "'-1' is not a positive number");
}

}  // namespace
}  // namespace piae::cli
