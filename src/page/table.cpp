#include "page/table.hpp"

#include <spdlog/fmt/fmt.h>

#include "page/html.hpp"

namespace piae::page {

namespace {

/// Number of rows from which a table can be filtered.
constexpr std::size_t long_table = 25;

Html content_of_cell(const text::Cell& cell) {
  if (cell.is_digest) return element("code", cell.text);
  Html content;
  for (const auto& file : cell.files) {
    if (!content.empty()) content += " ";
    content += file_link(file);
  }
  if (cell.more.empty()) return content + cell.text;
  content += element("span", {{"class", "ours"}}, cell.text);
  for (const std::string& line : cell.more) {
    if (!line.empty()) content += element("span", {{"class", "theirs"}}, line);
  }
  return content;
}

Html html_of_row(const text::Row& row, const std::vector<text::Column>& columns) {
  Html cells;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].shown == text::Shown::in_csv) continue;
    const text::Cell& cell = row.cells[i];
    const bool is_name = cells.empty();
    Attributes attributes;
    std::string looks = cell.looks;
    if (columns[i].is_number) looks += looks.empty() ? "number" : " number";
    if (!looks.empty()) attributes.push_back({"class", looks});
    if (cell.number) attributes.push_back({"data-sort", fmt::format("{:.9g}", *cell.number)});
    if (!cell.source.empty()) attributes.push_back({"title", cell.source});
    if (is_name) attributes.push_back({"scope", "row"});
    cells += element(is_name ? "th" : "td", attributes, content_of_cell(cell));
  }
  Attributes attributes;
  if (!row.looks.empty()) attributes.push_back({"class", row.looks});
  return element("tr", attributes, cells);
}

Html html_of_header(const std::vector<text::Column>& columns) {
  Html cells;
  for (const text::Column& column : columns) {
    if (column.shown == text::Shown::in_csv) continue;
    Attributes attributes{{"scope", "col"}};
    if (column.is_number) attributes.push_back({"class", "number"});
    cells += element("th", attributes, column.heading);
  }
  return element("thead", element("tr", cells));
}

}  // namespace

Html html(const report::Section& section) {
  const text::Table& table = section.table;
  Html rows;
  for (const text::Row& row : table.rows()) rows += html_of_row(row, table.columns());
  const std::string looks = table.rows().size() >= long_table ? "sortable long" : "sortable";
  const Html content =
      element("caption", section.title) + html_of_header(table.columns()) + element("tbody", rows);
  // tabindex lets the keyboard reach a box that scrolls.
  Html all = element(
      "div",
      {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", section.title}},
      element("table", {{"class", looks}}, content));
  if (!section.note.empty()) all += element("p", {{"class", "below"}}, section.note);
  return all;
}

}  // namespace piae::page
