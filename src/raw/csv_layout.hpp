#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "raw/signal.hpp"

namespace piae::raw {

/// Layout of one column's numbers in a text of columns.
struct CsvLayout {
  char separator = ',';
  std::size_t fields = 0;      ///< number of fields in each line
  std::size_t column = 0;      ///< index, counted from 0
  bool has_name = false;       ///< true if the lines above name the column, and all others
  std::size_t names = 0;       ///< number of words in the line above the numbers
  std::size_t first_line = 1;  ///< first line with numbers, counted from 1
  std::string_view numbers;    ///< text from first_line on
  Times times = {};            ///< column of times, if there may be one, and its name
};

/// Finds a column by its number, counted from 1, or by its name in the header. The numbers may
/// follow blank lines, comments (# or %), an instrument's text, the header and lines of words, such
/// as units, up to line 10,000. The header may be a comment. Throws Error(bad_input) with file and
/// line if the column is missing. Also throws if a line before the numbers is neither text nor
/// numbers, because such a line is damaged.
CsvLayout csv_layout(const std::filesystem::path& file, std::string_view text,
                     const std::string& column);

/// Throws Error(bad_input) with "<file>, line <n>: <what>".
[[noreturn]] void refuse_csv_line(const std::filesystem::path& file, std::size_t line,
                                  const std::string& what);
/// Refuses the last number of a text that seems to be cut within the number.
[[noreturn]] void refuse_cut_number(const std::filesystem::path& file, std::size_t line,
                                    std::string_view number);
/// Returns a field in quotes, cut if it is long.
std::string csv_field_in_quotes(std::string_view field);

}  // namespace piae::raw
