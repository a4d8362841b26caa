#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::report {

/// A table for people: columns are padded to equal width, so that it reads well as plain text also
/// where it is Markdown.
class TextTable {
 public:
  /// The first `left_columns` columns hold words and stand left, the others numbers and stand
  /// right.
  TextTable(std::vector<std::string> header, std::size_t left_columns)
      : rows_{std::move(header)}, left_columns_(left_columns) {}

  /// Cells that are missing at the end are empty.
  void row(std::vector<std::string> cells);

  [[nodiscard]] std::string plain() const;
  [[nodiscard]] std::string markdown() const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::string padded(const std::string& cell, std::size_t column,
                                   std::size_t width) const;

  std::vector<std::vector<std::string>> rows_;  // the first is the header
  std::size_t left_columns_;
};

}  // namespace piae::report
