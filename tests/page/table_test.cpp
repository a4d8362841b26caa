#include "page/table.hpp"

#include <gmock/gmock.h>

namespace piae::page {
namespace {

using testing::HasSubstr;
using testing::Not;

Table two_rows() {
  return {.caption = "Accuracy, percent",
          .columns = {{"method"}, {"10:1", true}},
          .rows = {{.cells = {{.content = "vae"},
                              {.content = "85.40", .number = 85.4, .from = "a/diagnosis.h5"}}},
                   {.cells = {{.content = "<b>"}, {.content = "–"}}, .looks = "bad"}}};
}

TEST(PageTable, NamesItsRowsAndColumnsForThoseWhoCannotSeeIt) {
  const std::string text = html(two_rows()).text();
  EXPECT_THAT(text, HasSubstr("<caption>Accuracy, percent</caption>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"col\">method</th>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"row\">vae</th>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"row\">&lt;b&gt;</th>"));
}

TEST(PageTable, ANumberHasWhatItIsSortedByAndWhereItCameFrom) {
  const std::string text = html(two_rows()).text();
  EXPECT_THAT(
      text,
      HasSubstr("<td class=\"number\" data-sort=\"85.4\" title=\"a/diagnosis.h5\">85.40</td>"));
  EXPECT_THAT(text, HasSubstr("<td class=\"number\">–</td>"));
}

TEST(PageTable, ScrollsInABoxThatTheKeyboardReaches) {
  EXPECT_THAT(html(two_rows()).text(),
              HasSubstr("<div class=\"scroll\" role=\"region\" tabindex=\"0\" "
                        "aria-label=\"Accuracy, percent\">"));
}

TEST(PageTable, OnlyALongOneIsFiltered) {
  Table table = two_rows();
  EXPECT_THAT(html(table).text(), Not(HasSubstr("long")));
  table.rows.resize(25, table.rows.front());
  EXPECT_THAT(html(table).text(), HasSubstr("<table class=\"sortable long\">"));
}

TEST(PageTable, SaysBelowWhereItsNumbersComeFrom) {
  Table table = two_rows();
  table.below = "From a & b.";
  EXPECT_THAT(html(table).text(), HasSubstr("<p class=\"below\">From a &amp; b.</p>"));
}

}  // namespace
}  // namespace piae::page
