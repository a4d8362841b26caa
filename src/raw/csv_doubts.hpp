#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "raw/csv_layout.hpp"

namespace piae::raw {

/// The field of the column in a line, and others that tell what it is.
struct CsvRow {
  std::string_view asked;
  std::string_view first;    ///< of the line
  std::string_view partner;  ///< with which it may be one number, cut at its decimal comma
  std::string_view time;     ///< that of the column of times
};

/// Looks for signs that a column is not what it seems, line by line: numbers with sign between
/// thousands, which could be decimals, and lines that are not of the table.
class CsvDoubts {
 public:
  CsvDoubts(const std::filesystem::path& file, const CsvLayout& layout)
      : file_(file), layout_(layout) {}

  /// Takes the next line, `all`. Throws Error(bad_input) where it has both decimal signs.
  void look_at(std::size_t line, const CsvRow& row, std::string_view all);
  /// Throws Error(bad_input), with the line, where the column may be read in two ways.
  void require_none() const;

 private:
  void look_at_comma(std::size_t line, std::string_view field, std::string_view all);

  const std::filesystem::path& file_;
  const CsvLayout& layout_;
  std::size_t commas_ = 0;        ///< numbers with a comma
  std::size_t in_thousands_ = 0;  ///< of these, such as 2,401
  std::string_view comma_;
  std::size_t comma_line_ = 0;
  bool all_in_groups_ = true;
  bool any_padded_ = false;
  std::size_t worded_ = 0;    ///< lines that begin with a word
  std::size_t numbered_ = 0;  ///< and the others
  std::string_view word_;
  std::size_t word_line_ = 0;
};

}  // namespace piae::raw
