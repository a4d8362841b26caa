#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace piae::text {

/// A table for people, and the ways in which it can be written. Cells are plain text; each way of
/// writing escapes what it must.
class Table {
 public:
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

  /// The first `left_columns` columns hold words, which are aligned left; the others hold numbers,
  /// which are aligned right.
  Table(std::vector<std::string> header, std::size_t left_columns)
      : rows_{std::move(header)}, left_columns_(left_columns) {}

  /// Adds a row. Cells may be missing at its end; they are empty. A row whose first cell is empty
  /// belongs to the row above it.
  void row(std::vector<std::string> cells);

  /// For a terminal, with columns padded by spaces.
  [[nodiscard]] std::string plain() const;
  /// As Markdown, also padded, so that the file itself is easy to read. Where its lines would be
  /// longer than `widest` characters, it is written as several tables below each other: each has
  /// the columns of words and some of those of numbers. A column is never cut.
  [[nodiscard]] std::string markdown(std::size_t widest = no_limit) const;
  /// As a LaTeX tabular in the style of the package booktabs.
  [[nodiscard]] std::string latex() const;

 private:
  using Rows = std::vector<std::vector<std::string>>;

  /// Some columns, by their numbers.
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
