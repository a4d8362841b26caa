#pragma once

#include <optional>
#include <span>

#include "report/accuracies.hpp"
#include "report/columns.hpp"

namespace piae::report {

/// A number that tables show of each method and ratio. One entry in accuracy_columns.cpp is all
/// that a column needs: accuracy.csv, gains.csv, the table that `tabulate` prints, tables.md and
/// tables.tex have it, and so has each cell of the tables in report.html, as a line of its own.
struct AccuracyColumn {
  const char* field = "";     ///< its name in CSV; empty where CSV does not have it
  const char* terminal = "";  ///< its heading in the terminal; empty where it is not there
  const char* heading = "";   ///< in documents, and before the number on a page; empty likewise
  /// Set where the column is left out of data sets that tell kinds of defect apart (false), or of
  /// all others (true).
  std::optional<bool> kinds = {};
  /// `style` is that of accuracies, or of gains.
  text::Cell (*cell)(const AccuracyRow& row, NumberStyle style);
};

/// In their order. Documents and pages leave out a column in which no row has anything.
std::span<const AccuracyColumn> accuracy_columns();

}  // namespace piae::report
