#include <gtest/gtest.h>

#include "report/csv.hpp"
#include "report/text_table.hpp"

namespace piae::report {
namespace {

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_line({"a", "", "1.5"}), "a,,1.5\n");
  EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}),
            "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

TextTable table() {
  TextTable table({"name", "value"}, 1);
  table.row({"longer name", "1.00 ± 0.20"});
  table.row({"x"});
  table.row({"y", "2"});
  return table;
}

TEST(TextTable, IsAlignedForATerminalWithoutTrailingSpace) {
  EXPECT_EQ(table().plain(),
            "name               value\n"
            "longer name  1.00 ± 0.20\n"
            "x\n"
            "y                      2\n");
}

TEST(TextTable, IsAlignedAsMarkdown) {
  EXPECT_EQ(table().markdown(),
            "| name        |       value |\n"
            "|-------------|------------:|\n"
            "| longer name | 1.00 ± 0.20 |\n"
            "| x           |             |\n"
            "| y           |           2 |\n");
}

}  // namespace
}  // namespace piae::report
