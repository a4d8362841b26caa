#include <gmock/gmock.h>

#include "text/csv.hpp"
#include "report/document.hpp"
#include "text/escape.hpp"
#include "report/labels.hpp"

namespace piae::report {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_line({"a", "", "1.5"}), "a,,1.5\n");
  EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}),
            "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
}

TEST(Labels, OfNumbersWithAndWithoutASpread) {
  const scoring::Summary one{1, 12.345, {}, {}};
  const scoring::Summary two{2, -1.5, 0.125, scoring::Summary::Interval{-2, 3}};
  EXPECT_EQ(mean_label(one), "12.35");
  EXPECT_EQ(interval_label(one), "");
  EXPECT_EQ(mean_label(two, {.decimals = 1, .sign = true}), "-1.5 ± 0.1");
  EXPECT_EQ(interval_label(two, {.sign = true}), "[-2.00, +3.00]");
}

TEST(Labels, OfRatiosTellTheTrueOneWhereItDiffers) {
  EXPECT_EQ(ratio_label("25to1", 25), "25:1");
  EXPECT_EQ(ratio_label("2to1", 500.0 / 150), "2:1 (3.33:1)");
  EXPECT_EQ(ratio_label("100to1", 30.0 / 5), "100:1 (6:1)");
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

TEST(Table, RowsThatGoOnStayTogetherInLatex) {
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

TEST(Escape, OfMarkdown) {
  EXPECT_EQ(markdown_text("a|b *c* `d` <e> \\ f_g [1, 2]"),
            "a\\|b \\*c\\* \\`d\\` \\<e> \\\\ f_g [1, 2]");
}

TEST(Escape, OfLatex) {
  EXPECT_EQ(latex_text("a_b & 95 % #1 $ {x} ~ ^ \\ < > |"),
            "a\\_b \\& 95 \\% \\#1 \\$ \\{x\\} \\textasciitilde{} \\textasciicircum{} "
            "\\textbackslash{} \\textless{} \\textgreater{} \\textbar{}");
  EXPECT_EQ(latex_text("MMD² of Größe"), "MMD$^2$ of Größe");
  EXPECT_EQ(latex_text("[-2.00, +3.00]"), "{[}$-$2.00, $+$3.00{]}");
  EXPECT_EQ(latex_text("-1.5 ± 0.1 of piae-dt-2, cold - warm -"),
            "$-$1.5 $\\pm$ 0.1 of piae-dt-2, cold - warm -");
}

Document document() {
  return {"my_set",
          "Title of my_set",
          {std::string(99, 'w') + " over the end.", "Second."},
          {{"one", "Table one", "A note, 5 %.", table()}, {"two", "Table two", "", table()}}};
}

TEST(Document, AsMarkdown) {
  EXPECT_EQ(markdown(document()), "# Title of my_set\n\n" + std::string(99, 'w') +
                                      "\nover the end.\n\nSecond.\n\n## Table one\n\n"
                                      "A note, 5 %.\n\n" +
                                      table().markdown() + "\n## Table two\n\n" +
                                      table().markdown());
}

TEST(Document, AsLatex) {
  const std::string text = latex(document());
  EXPECT_THAT(text, testing::StartsWith("% Title of my\\_set\n"
                                        "% For \\input. In the preamble: "
                                        "\\usepackage{booktabs,graphicx}\n\n"));
  EXPECT_THAT(text, HasSubstr("\nSecond.\n\n\\begin{table}\n\\centering\n"
                              "\\caption{Table one. A note, 5 \\%.}\n"
                              "\\label{tab:my-set-one}\n\\resizebox{"));
  EXPECT_THAT(text, HasSubstr("\\caption{Table two.}\n\\label{tab:my-set-two}\n"));
  EXPECT_THAT(text, EndsWith("{!}{%\n" + table().latex() + "}\n\\end{table}\n"));
}

}  // namespace
}  // namespace piae::report
