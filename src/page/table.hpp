#pragma once

#include <optional>
#include <string>
#include <vector>

#include "page/html.hpp"

namespace piae::page {

/// A cell of a table.
struct Cell {
  Html content;
  std::optional<double> number = {};  ///< what it is sorted by; its text where there is none
  std::string looks = {};             ///< class of the style sheet
  std::string from = {};              ///< which artefact its number came from
};

/// The cell of a number as the table shows it.
Cell number_cell(double number, const Html& shown);

struct Column {
  Html title;
  bool is_number = false;
};

struct Row {
  std::vector<Cell> cells;  ///< the first names the row
  std::string looks = {};   ///< class of the style sheet
};

/// A table that scrolls in a box of its own where the window is too narrow for it. The page's
/// script sorts it by a click on a column's title, and filters it where it is long.
struct Table {
  std::string caption;  ///< what it shows, and in which unit
  std::vector<Column> columns;
  std::vector<Row> rows = {};
  Html below = {};  ///< where the numbers come from, and how to read them
};

Html html(const Table& table);

}  // namespace piae::page
