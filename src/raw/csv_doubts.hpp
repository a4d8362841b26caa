#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "raw/csv_layout.hpp"

namespace piae::raw {

/// Fields of a line: the requested one and those that show whether it is a sample.
struct CsvRow {
  std::string_view requested_field;
  std::string_view first;    ///< first field of the line
  std::string_view partner;  ///< may be part of the same number
  std::string_view time;     ///< field of the column of times
};

/// Looks line by line for signs that a column is not what it seems: numbers with separators of
/// thousands, which could be decimal signs, and lines that do not belong to the table.
class CsvDoubts {
 public:
  CsvDoubts(const std::filesystem::path& file, const CsvLayout& layout)
      : file_(file), layout_(layout) {}

  /// Checks the next line, `all`. Throws Error(bad_input) if it has both decimal signs.
  void look_at(std::size_t line, const CsvRow& row, std::string_view all);
  /// Throws Error(bad_input), with the line, if the column is ambiguous.
  void require_none() const;

 private:
  void look_at_comma(std::size_t line, std::string_view field, std::string_view all);

  const std::filesystem::path& file_;
  const CsvLayout& layout_;
  std::size_t commas_ = 0;        ///< numbers with a comma
  std::size_t in_thousands_ = 0;  ///< numbers with a comma such as 2,401
  std::string_view comma_;
  std::size_t comma_line_ = 0;
  bool all_in_groups_ = true;
  bool any_padded_ = false;
  std::size_t worded_ = 0;    ///< lines that start with a word
  std::size_t numbered_ = 0;  ///< lines that do not
  std::string_view word_;
  std::size_t word_line_ = 0;
};

}  // namespace piae::raw
