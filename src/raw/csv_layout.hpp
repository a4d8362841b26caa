#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "raw/signal.hpp"

namespace piae::raw {

/// Where the numbers of one column stand in a text of columns.
struct CsvLayout {
  char separator = ',';
  std::size_t fields = 0;      ///< of each line
  std::size_t column = 0;      ///< counted from 0
  bool has_name = false;       ///< a header above it has as many fields, and a name for the column
  std::size_t first_line = 1;  ///< that holds numbers, counted from 1
  std::string_view numbers;    ///< the text from that line on
  Times times = {};            ///< the column of times, if there may be one, and its name
};

/// Finds a column by its number, counted from 1, or by its name in the header. Before the numbers
/// there may be blank lines, comments (# or % begins them), lines of text such as an instrument
/// writes, the header, which may be such a comment, and below it a line of units. Throws
/// Error(bad_input) with the file and the line where there is no such column, and where a line
/// before the numbers is neither text nor of numbers, as a damaged one is.
CsvLayout csv_layout(const std::filesystem::path& file, std::string_view text,
                     const std::string& column);

/// "<file>, line <n>: <what>"; and a field in quotes, cut where it is long.
[[noreturn]] void refuse_csv_line(const std::filesystem::path& file, std::size_t line,
                                  const std::string& what);
std::string csv_field_in_quotes(std::string_view field);

}  // namespace piae::raw
