#include "report/document.hpp"

#include <gmock/gmock.h>

namespace piae::report {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

text::Table table() {
  text::Table table({"name", "value"}, 1);
  table.row({"x", "1.00 ± 0.20"});
  return table;
}

Document document() {
  return {"my_set",
          "Title of my_set",
          {std::string(99, 'w') + " over the end.", "Second."},
          {{"one", "Table one", "A note, 5 %.", table()}, {"two", "Table two", "", table()}}};
}

TEST(Document, WritesMarkdown) {
  EXPECT_EQ(markdown(document()), "# Title of my_set\n\n" + std::string(99, 'w') +
                                      "\nover the end.\n\nSecond.\n\n## Table one\n\n"
                                      "A note, 5 %.\n\n" +
                                      table().markdown() + "\n## Table two\n\n" +
                                      table().markdown());
}

TEST(Document, WritesMarkdownOfAtMost100Characters) {
  text::Table wide({"class", std::string(45, 'a'), std::string(45, 'b')}, 1);
  wide.row({"IR", "1", "2"});
  const std::string text = markdown({"key", "Title", {}, {{"wide", "Wide", "", wide}}});
  EXPECT_THAT(text, HasSubstr("| class | " + std::string(45, 'a') + " |\n"));
  EXPECT_THAT(text, HasSubstr("|\n\n| class | " + std::string(45, 'b') + " |\n"));
}

TEST(Document, WritesLatexToInclude) {
  const std::string text = latex(document());
  EXPECT_THAT(text, testing::StartsWith("% Title of my\\_set\n"
                                        "% For \\input. In the preamble: "
                                        "\\usepackage{booktabs,graphicx}\n\n"));
  EXPECT_THAT(text, HasSubstr("\nSecond.\n\n\\begin{table}\n\\centering\n"
                              "\\caption{Table one. A note, 5 \\%.}\n"
                              "\\label{tab:my-set-one}\n\\resizebox*{!}{"));
  EXPECT_THAT(text, HasSubstr("\\caption{Table two.}\n\\label{tab:my-set-two}\n"));
  EXPECT_THAT(text, EndsWith("{!}{%\n" + table().latex() + "}}\n\\end{table}\n"));
}

}  // namespace
}  // namespace piae::report
