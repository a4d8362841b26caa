#include "text/wrap.hpp"

#include <gtest/gtest.h>

namespace piae::text {
namespace {

TEST(Wrap, BreaksBetweenWords) {
  EXPECT_EQ(wrap("one two three", 7), "one two\nthree\n");
  EXPECT_EQ(wrap("one two three", 13), "one two three\n");
}

TEST(Wrap, IndentsEveryLine) { EXPECT_EQ(wrap("one two three", 9, 2), "  one two\n  three\n"); }

TEST(Wrap, KeepsALongWordWhole) { EXPECT_EQ(wrap("a longest b", 4), "a\nlongest\nb\n"); }

}  // namespace
}  // namespace piae::text
