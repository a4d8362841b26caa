#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "raw/csv_fields.hpp"
#include "raw/csv_layout.hpp"
#include "raw/torn_decimals.hpp"

namespace piae::raw {

/// Fields of a line: the requested one and those that show whether it is a sample.
struct CsvRow {
  std::string_view requested_field;
  std::string_view first;     ///< first field of the line
  std::string_view previous;  ///< field before the requested one; empty if it is the first
  std::string_view next;      ///< field behind the requested one; empty if it is the last
  std::string_view time;      ///< field of the column of times
};

/// Looks line by line for signs that a column is not what it seems: numbers with separators of
/// thousands, which could be decimal signs, lines that do not belong to the table, a cut last
/// number, and damaged times, between which lines may be missing.
class CsvDoubts {
 public:
  CsvDoubts(const std::filesystem::path& file, const CsvLayout& layout, const std::string& column)
      : file_(file), layout_(layout), column_(column) {}

  /// Checks the next line, `all`. Throws Error(bad_input) if it has both decimal signs.
  void look_at(std::size_t line, const CsvRow& row, std::string_view all);
  /// Throws Error(bad_input), with the line, if the column is ambiguous.
  void require_none() const;
  /// True if the last number may be cut, after require_none().
  [[nodiscard]] bool may_be_cut() const { return may_be_cut_ && decimals_.has_rare_end(); }

 private:
  /// Lines that differ from the others; the first one is kept for the error.
  struct Others {
    std::size_t count = 0;
    std::size_t usual = 0;  ///< lines that do not differ
    std::string_view field;
    std::size_t line = 0;

    void add(bool differs, std::size_t number, std::string_view text);
    [[nodiscard]] bool are_few() const { return count > 0 && count <= usual; }
  };

  void look_at_comma(std::size_t line, std::string_view field, std::string_view all);
  void require_no_decimal_commas() const;

  const std::filesystem::path& file_;
  const CsvLayout& layout_;
  const std::string& column_;     ///< its name or number
  std::size_t commas_ = 0;        ///< numbers with a comma
  std::size_t in_thousands_ = 0;  ///< numbers with a comma such as 2,401
  std::string_view comma_;
  std::size_t comma_line_ = 0;
  bool all_in_groups_ = true;
  bool any_padded_ = false;
  bool has_points_ = false;  ///< true if a number of a line has a decimal point
  TornDecimals before_;      ///< previous and requested field
  TornDecimals behind_;      ///< requested and next field
  Others words_;             ///< lines that start with a word
  Decimals decimals_;
  bool may_be_cut_ = false;  ///< true if the column's last number ends the text, without a line end
  Others times_;             ///< lines whose time is damaged
};

}  // namespace piae::raw
