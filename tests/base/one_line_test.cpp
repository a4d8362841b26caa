#include "base/one_line.hpp"

#include <gtest/gtest.h>

namespace piae {
namespace {

TEST(OneLine, KeepsPrintableText) {
  const std::string text = "Lagerschäden, 轴承, \xF0\x9F\x94\xA7 and 'a b'";
  EXPECT_FALSE(has_control_characters(text));
  EXPECT_EQ(one_line(text), text);
  EXPECT_EQ(one_line(""), "");
}

TEST(OneLine, RemovesTerminalCommands) {
  EXPECT_EQ(one_line("a\nb\tc\x1b[2J\x7f"), "a?b?c?[2J?");
  EXPECT_EQ(one_line("\xC2\x80 \xC2\x9B"
                     "2J \xC2\x9F \xC2\xA0"),
            "? ?2J ? \xC2\xA0");
  EXPECT_EQ(one_line({"a\0b", 3}), "a?b");
}

TEST(OneLine, RemovesLineBreaksAndDirectionMarks) {
  for (const std::string mark :
       {"\xD8\x9C", "\xE2\x80\x8E", "\xE2\x80\x8F", "\xE2\x80\xA8", "\xE2\x80\xA9", "\xE2\x80\xAA",
        "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x81\xA9"}) {
    EXPECT_TRUE(has_control_characters("a" + mark + "b"));
    EXPECT_EQ(one_line("a" + mark + "b"), "a?b");
  }
  EXPECT_FALSE(has_control_characters("\xE2\x80\x90 \xE2\x80\xAF \xE2\x81\xA5"));
}

TEST(OneLine, RemovesInvalidUtf8) {
  for (const std::string bytes : {
           "\x9B",                              // not a first byte
           "\xC2", "\xE2\x80", "\xF0\x9F\x94",  // cut
           "\xC2z", "\xE2\x80z",                // continued by another character
           "\xC0\x8A", "\xC1\x9F", "\xE0\x80\x8A", "\xF0\x80\x80\x8A",  // not the shortest form
           "\xED\xA0\x80",                                              // half of a surrogate pair
           "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF",          // above U+10FFFF
       }) {
    EXPECT_TRUE(has_control_characters(bytes)) << testing::PrintToString(bytes);
    const std::string line = one_line(bytes);
    EXPECT_EQ(line.find_first_not_of("?z"), std::string::npos) << testing::PrintToString(bytes);
  }
}

TEST(OneLine, LimitsTheLength) {
  const std::string full(1000, 'x');
  EXPECT_EQ(one_line(full), full);
  EXPECT_EQ(one_line(full + "y"), full + "...");
  const std::string nearly(999, 'x');
  EXPECT_EQ(one_line(nearly + "\xC3\xA4"), nearly + "...");
}

}  // namespace
}  // namespace piae
