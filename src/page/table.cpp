#include "page/table.hpp"

#include <spdlog/fmt/fmt.h>

namespace piae::page {

namespace {

/// From so many rows on, a table can be filtered.
constexpr std::size_t long_table = 25;

Attributes attributes_of(const Cell& cell, bool is_number) {
  Attributes attributes;
  std::string looks = cell.looks;
  if (is_number) looks += looks.empty() ? "number" : " number";
  if (!looks.empty()) attributes.push_back({"class", looks});
  if (cell.number) attributes.push_back({"data-sort", fmt::format("{:.9g}", *cell.number)});
  if (!cell.from.empty()) attributes.push_back({"title", cell.from});
  return attributes;
}

Html html_of_row(const Row& row, const std::vector<Column>& columns) {
  Html cells;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    Attributes attributes = attributes_of(row.cells[i], columns.at(i).is_number);
    if (i == 0) attributes.push_back({"scope", "row"});
    cells += element(i == 0 ? "th" : "td", attributes, row.cells[i].content);
  }
  Attributes attributes;
  if (!row.looks.empty()) attributes.push_back({"class", row.looks});
  return element("tr", attributes, cells);
}

Html html_of_header(const std::vector<Column>& columns) {
  Html cells;
  for (const Column& column : columns) {
    Attributes attributes{{"scope", "col"}};
    if (column.is_number) attributes.push_back({"class", "number"});
    cells += element("th", attributes, column.title);
  }
  return element("thead", element("tr", cells));
}

}  // namespace

Cell number_cell(double number, const Html& shown) { return {.content = shown, .number = number}; }

Html html(const Table& table) {
  Html rows;
  for (const Row& row : table.rows) rows += html_of_row(row, table.columns);
  const std::string looks = table.rows.size() >= long_table ? "sortable long" : "sortable";
  const Html content =
      element("caption", table.caption) + html_of_header(table.columns) + element("tbody", rows);
  // A box that scrolls can be reached by the keyboard.
  Html all = element(
      "div",
      {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", table.caption}},
      element("table", {{"class", looks}}, content));
  if (!table.below.empty()) all += element("p", {{"class", "below"}}, table.below);
  return all;
}

}  // namespace piae::page
