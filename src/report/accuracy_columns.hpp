#pragma once

#include <optional>
#include <span>

#include "report/accuracies.hpp"
#include "report/columns.hpp"

namespace piae::report {

/// A number that tables show for each method and ratio. One entry in accuracy_columns.cpp adds a
/// column to accuracy.csv, gains.csv, tables.md, tables.tex and the table that `tabulate` prints.
/// It also adds a line to each cell of the tables in report.html.
struct AccuracyColumn {
  const char* field = "";     ///< its name in CSV; empty if CSV does not have the column
  const char* terminal = "";  ///< its heading in the terminal; empty if not shown there
  const char* heading =
      "";  ///< in documents, and before the number on a page; empty if shown in neither
  /// True: only for data sets with fault types. False: only for data sets without. Empty: for all.
  std::optional<bool> types = {};
  /// `style` is the style of accuracies or of gains.
  text::Cell (*cell)(const AccuracyRow& row, NumberStyle style);
};

/// Returns the columns in order. Documents and pages leave out a column that is empty in all rows.
std::span<const AccuracyColumn> accuracy_columns();

}  // namespace piae::report
