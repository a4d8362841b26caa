#include "page/table.hpp"

#include <gmock/gmock.h>

namespace piae::page {
namespace {

using testing::HasSubstr;
using testing::Not;

report::Section two_rows() {
  text::Table table({"method", "10:1"}, 1);
  text::Cell accuracy = "85.40";
  accuracy.number = 85.4;
  accuracy.source = "a/diagnosis.h5";
  table.row({"vae", accuracy});
  table.row({"<b>", "–"}, "bad");
  return {"accuracy", "Accuracy, percent", "", table};
}

TEST(PageTable, LabelsRowsAndColumnsForScreenReaders) {
  const std::string text = html(two_rows()).text();
  EXPECT_THAT(text, HasSubstr("<caption>Accuracy, percent</caption>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"col\">method</th>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"row\">vae</th>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"row\">&lt;b&gt;</th>"));
}

TEST(PageTable, StoresSortKeyAndSourceOfANumber) {
  const std::string text = html(two_rows()).text();
  EXPECT_THAT(
      text,
      HasSubstr("<td class=\"number\" data-sort=\"85.4\" title=\"a/diagnosis.h5\">85.40</td>"));
  EXPECT_THAT(text, HasSubstr("<td class=\"number\">–</td>"));
}

TEST(PageTable, ScrollsInAFocusableBox) {
  EXPECT_THAT(html(two_rows()).text(),
              HasSubstr("<div class=\"scroll\" role=\"region\" tabindex=\"0\" "
                        "aria-label=\"Accuracy, percent\">"));
}

TEST(PageTable, ShowsFurtherLinesAndLinksInACell) {
  text::Table table({"a", "b", "c"}, 3);
  text::Cell lines = "90.00";
  lines.more = {"paper 91.20", ""};
  text::Cell files = " and 1 more";
  files.files = {"x.log", "y.log"};
  text::Cell digest = "0a1b";
  digest.is_digest = true;
  table.row({lines, files, digest});
  const std::string text = html(report::Section{"k", "T", "", table}).text();
  EXPECT_THAT(text, HasSubstr("<span class=\"ours\">90.00</span>"
                              "<span class=\"theirs\">paper 91.20</span></th>"));
  EXPECT_THAT(text, HasSubstr("<a href=\"./x.log\">x.log</a> <a href=\"./y.log\">y.log</a> and 1 "
                              "more</td>"));
  EXPECT_THAT(text, HasSubstr("<code>0a1b</code>"));
}

TEST(PageTable, ShowsColumnsOfPagesButNotOfCsv) {
  text::Table table({"method"}, 1);
  table.column({"alarms", true, "", text::Shown::on_pages});
  table.column({"std", true, "std", text::Shown::in_csv});
  table.row({"vae", "2.0", "0.1234"});
  const std::string text = html(report::Section{"k", "T", "", table}).text();
  EXPECT_THAT(text, HasSubstr("2.0"));
  EXPECT_THAT(text, Not(HasSubstr("0.1234")));
  EXPECT_EQ(table.plain(), "method\nvae\n");
  EXPECT_EQ(table.csv(), "std\n0.1234\n");
}

TEST(PageTable, HasAFilterOnlyIfLong) {
  report::Section section = two_rows();
  EXPECT_THAT(html(section).text(), Not(HasSubstr("long")));
  for (int i = 2; i < 25; ++i) section.table.row({"vae", "1"});
  EXPECT_THAT(html(section).text(), HasSubstr("<table class=\"sortable long\">"));
}

TEST(PageTable, NamesTheSourceBelow) {
  report::Section section = two_rows();
  section.note = "From a & b.";
  EXPECT_THAT(html(section).text(), HasSubstr("<p class=\"below\">From a &amp; b.</p>"));
}

}  // namespace
}  // namespace piae::page
