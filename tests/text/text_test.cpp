#include <gmock/gmock.h>

#include "text/csv.hpp"
#include "text/escape.hpp"
#include "text/table.hpp"

namespace piae::text {
namespace {

using testing::HasSubstr;

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_line({"a", "", "1.5"}), "a,,1.5\n");
  EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}),
            "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

Table table() {
  Table table({"name", "value"}, 1);
  table.row({"longer name", "1.00 ± 0.20"});
  table.row({"x"});
  table.row({"y|", "2"});
  return table;
}

TEST(Table, IsAlignedForATerminalWithoutTrailingSpace) {
  EXPECT_EQ(table().plain(),
            "name               value\n"
            "longer name  1.00 ± 0.20\n"
            "x\n"
            "y|                     2\n");
}

TEST(Table, IsAlignedAsMarkdown) {
  EXPECT_EQ(table().markdown(),
            "| name        |       value |\n"
            "|-------------|------------:|\n"
            "| longer name | 1.00 ± 0.20 |\n"
            "| x           |             |\n"
            "| y\\|         |           2 |\n");
}

/// Returns a table with three numbers of 7 characters: 8 + 3 * 10 + 1 characters wide.
Table wide_table() {
  Table table({"class", "first", "second", "third"}, 1);
  table.row({"IR", "1234567", "1234567", "1234567"});
  return table;
}

TEST(Table, IsSplitIfTooWide) {
  EXPECT_EQ(wide_table().markdown(39), wide_table().markdown());
  EXPECT_EQ(wide_table().markdown(38),
            "| class |   first |\n"
            "|-------|--------:|\n"
            "| IR    | 1234567 |\n"
            "\n"
            "| class |  second |   third |\n"
            "|-------|--------:|--------:|\n"
            "| IR    | 1234567 | 1234567 |\n");
}

TEST(Table, NeverCutsAColumn) {
  EXPECT_EQ(wide_table().markdown(10), wide_table().markdown(19));
  EXPECT_THAT(wide_table().markdown(10), HasSubstr("| class |  second |\n"));
  Table words({"class", "meaning"}, 2);
  words.row({"IR", "inner raceway"});
  EXPECT_EQ(words.markdown(10), words.markdown());
}

TEST(Table, IsATabularInLatex) {
  EXPECT_EQ(table().latex(),
            "\\begin{tabular}{lr}\n"
            "  \\toprule\n"
            "  name & value \\\\\n"
            "  \\midrule\n"
            "  longer name & 1.00 $\\pm$ 0.20 \\\\\n"
            "  x &  \\\\\n"
            "  y\\textbar{} & 2 \\\\\n"
            "  \\bottomrule\n"
            "\\end{tabular}\n");
}

TEST(Table, KeepsContinuedRowsTogetherInLatex) {
  Table table({"", "", "n"}, 2);
  table.row({"a", "here", "1"});
  table.row({"", "paper", "2"});
  table.row({"b", "here", "3"});
  EXPECT_THAT(table.latex(), HasSubstr("  \\midrule\n"
                                       "  a & here & 1 \\\\\n"
                                       "   & paper & 2 \\\\\n"
                                       "  \\addlinespace\n"
                                       "  b & here & 3 \\\\\n"
                                       "  \\bottomrule\n"));
}

TEST(Table, HasTheColumnsWithACsvNameInCsv) {
  Table table({"method"}, 1);
  table.column({"accuracy", true, "mean"});
  table.column({"std", true, "std", Shown::in_csv});
  Cell mean = "85.40 ± 1.20";
  mean.field = "85.4012";
  table.row({"a", mean, "1.2034"});
  table.row({"b"});
  EXPECT_EQ(table.csv(), "mean,std\n85.4012,1.2034\n,\n");
  EXPECT_EQ(table.plain(), "method      accuracy\na       85.40 ± 1.20\nb\n");
}

TEST(Escape, KeepsPlainTextPlainInMarkdown) {
  EXPECT_EQ(markdown_text("a|b *c* `d` <e> \\ f_g [1, 2]"),
            "a\\|b \\*c\\* \\`d\\` \\<e> \\\\ f_g [1, 2]");
}

TEST(Escape, KeepsPlainTextPlainInLatex) {
  EXPECT_EQ(latex_text("a_b & 95 % #1 $ {x} ~ ^ \\ < > |"),
            "a\\_b \\& 95 \\% \\#1 \\$ \\{x\\} \\textasciitilde{} \\textasciicircum{} "
            "\\textbackslash{} \\textless{} \\textgreater{} \\textbar{}");
  EXPECT_EQ(latex_text("MMD² of Größe"), "MMD$^2$ of Größe");
  EXPECT_EQ(latex_text("– 0.5 † ‡"), "-- 0.5 $\\dagger$ $\\ddagger$");
  EXPECT_EQ(latex_text("[-2.00, +3.00]"), "{[}$-$2.00, $+$3.00{]}");
  EXPECT_EQ(latex_text("-1.5 ± 0.1 of piae-dt-2, cold - warm -"),
            "$-$1.5 $\\pm$ 0.1 of piae-dt-2, cold - warm -");
}

}  // namespace
}  // namespace piae::text
