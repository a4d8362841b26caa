#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace piae::text {

/// A table for people, and the ways in which it can be written. Cells are plain text; each way of
/// writing escapes what it must.
class Table {
 public:
  /// The first `left_columns` columns hold words and stand left, the others numbers and stand
  /// right.
  Table(std::vector<std::string> header, std::size_t left_columns)
      : rows_{std::move(header)}, left_columns_(left_columns) {}

  /// Cells that are missing at the end are empty. A row whose first cell is empty goes on with what
  /// the row before it has begun.
  void row(std::vector<std::string> cells);

  /// Padded to columns, for a terminal.
  [[nodiscard]] std::string plain() const;
  /// Padded too, so that it reads well as it is.
  [[nodiscard]] std::string markdown() const;
  /// A tabular in the style of the package booktabs.
  [[nodiscard]] std::string latex() const;

 private:
  using Rows = std::vector<std::vector<std::string>>;

  [[nodiscard]] std::string padded(const std::string& cell, std::size_t column,
                                   std::size_t width) const;

  Rows rows_;  // the first is the header
  std::size_t left_columns_;
};

}  // namespace piae::text
