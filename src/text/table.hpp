#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace piae::text {

/// A table for people in several formats. Cells are plain text, which each format escapes.
class Table {
 public:
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

  /// The first `left_columns` columns hold words, aligned left; the others hold numbers, aligned
  /// right.
  Table(std::vector<std::string> header, std::size_t left_columns)
      : rows_{std::move(header)}, left_columns_(left_columns) {}

  /// Adds a row. Missing cells at its end are empty. A row with an empty first cell belongs to the
  /// row above it.
  void row(std::vector<std::string> cells);

  /// Formats for a terminal, with columns padded by spaces.
  [[nodiscard]] std::string plain() const;
  /// Formats as Markdown, padded, so that the file itself is easy to read. If lines exceed `widest`
  /// characters, splits the table into several, one below the other: each has the columns of words
  /// and some columns of numbers. A column is never cut.
  [[nodiscard]] std::string markdown(std::size_t widest = no_limit) const;
  /// Formats as a LaTeX tabular in the style of the package booktabs.
  [[nodiscard]] std::string latex() const;

 private:
  using Rows = std::vector<std::vector<std::string>>;

  /// Column numbers.
  using Columns = std::vector<std::size_t>;

  [[nodiscard]] std::string padded(const std::string& cell, std::size_t column,
                                   std::size_t width) const;
  [[nodiscard]] std::vector<Columns> columns_in_groups(std::size_t groups) const;
  [[nodiscard]] std::string markdown_of(const Rows& rows, const Columns& columns,
                                        const std::vector<std::size_t>& width) const;

  Rows rows_;  // the first is the header
  std::size_t left_columns_;
};

}  // namespace piae::text
