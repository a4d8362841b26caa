#include "plan/changed_description.hpp"

#include <gtest/gtest.h>

namespace piae::plan {
namespace {

const std::string rig =
    "name = 'rig'\nrate = 12000\n[bearing]\nballs = 9\n[[record]]\nfile = "
    "'a.mat'\n[[record]]\nfile "
    "= ['b.csv', 'c.csv']\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = rig;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ChangedDescription, NamesTheKeyAndBothValues) {
  EXPECT_EQ(changed_key(rig, with("12000", "25600")), "rate is 25600, was 12000");
  EXPECT_EQ(changed_key(rig, with("9", "13")), "bearing.balls is 13, was 9");
  EXPECT_EQ(changed_key(rig, with("a.mat", "d.mat")), "record 1: file is 'd.mat', was 'a.mat'");
  EXPECT_EQ(changed_key(rig, with(", 'c.csv'", "")),
            "record 2: file is [ 'b.csv' ], was [ 'b.csv', 'c.csv' ]");
}

TEST(ChangedDescription, NamesAddedAndRemovedKeys) {
  EXPECT_EQ(changed_key(rig, with("balls = 9", "balls = 9\nplay = 0.1")),
            "bearing.play is 0.1, was not set");
  EXPECT_EQ(changed_key(rig, with("rate = 12000\n", "")), "rate is not set, was 12000");
  EXPECT_EQ(changed_key(rig, with("[bearing]\nballs = 9\n", "")),
            "bearing is not set, was a table");
  EXPECT_EQ(changed_key(rig, rig + "[[record]]\nfile = 'e'\n"), "record has 3 entries, had 2");
}

TEST(ChangedDescription, IsEmptyIfNoKeyDiffers) {
  EXPECT_EQ(changed_key(rig, rig), "");
  EXPECT_EQ(changed_key(rig, "# a comment\n" + rig), "");
  EXPECT_EQ(changed_key("not TOML", rig), "");
}

}  // namespace
}  // namespace piae::plan
