#include "scoring/ratios.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace piae::scoring {
namespace {

TEST(Ratios, MatchTable5) {
  std::vector<std::pair<std::string, int>> ratios;
  for (const Ratio& ratio : all_ratios())
    ratios.emplace_back(ratio.name, ratio.generated_per_class);
  using testing::Pair;
  EXPECT_THAT(ratios, testing::ElementsAre(Pair("100to1", 0), Pair("50to1", 5), Pair("25to1", 15),
                                           Pair("10to1", 45), Pair("5to1", 95), Pair("2to1", 145),
                                           Pair("1to1", 495)));
}

TEST(Ratios, UnknownRatioIsAUsageErrorThatListsTheOthers) {
  try {
    find_ratio("3to1");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_STREQ(error.what(),
                 "unknown ratio '3to1'; known: 100to1, 50to1, 25to1, 10to1, 5to1, 2to1, 1to1");
  }
}

TEST(Ratios, TrueRatioEqualsTheNameExceptForTwoToOne) {
  const auto of = [](const char* name) {
    return true_ratio(500, 5, find_ratio(name).generated_per_class);
  };
  EXPECT_EQ(of("100to1"), 100);
  EXPECT_EQ(of("50to1"), 50);
  EXPECT_EQ(of("25to1"), 25);
  EXPECT_EQ(of("10to1"), 10);
  EXPECT_EQ(of("5to1"), 5);
  EXPECT_NEAR(*of("2to1"), 3.3333, 1e-4);
  EXPECT_EQ(of("1to1"), 1);
}

TEST(Ratios, TrueRatioNeedsAFaultWindow) {
  EXPECT_EQ(true_ratio(495, 0, 0), std::nullopt);
  EXPECT_EQ(true_ratio(495, 0, 495), 1);
}

TEST(Ratios, AreListedWithTheirGeneratedWindows) {
  EXPECT_EQ(list_of_ratios(),
            "100to1 (0), 50to1 (5), 25to1 (15), 10to1 (45), 5to1 (95), 2to1 (145), 1to1 (495)");
}

}  // namespace
}  // namespace piae::scoring
