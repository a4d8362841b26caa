#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::text {

/// Returns one line of comma-separated values (RFC 4180, but ended by a line feed alone). Quotes
/// fields that contain a comma, a quote or a line feed.
std::string csv_line(const std::vector<std::string>& fields);

/// A line of a CSV file and its place.
struct CsvLine {
  std::string place;  ///< "table6-7-baseline.csv, line 3"
  std::vector<std::string> fields;

  /// Throws Error(bad_input) with the place.
  [[noreturn]] void refuse(const std::string& what) const;
  /// Returns field i as a number; empty if it is not a finite number.
  [[nodiscard]] std::optional<double> number(std::size_t i) const;
};

/// Reads all lines of a file except comments (#) and empty lines. The first line is the header.
/// Does not support quoted fields. Throws Error(input_missing) if the file cannot be read. Throws
/// Error(bad_input) if no line follows the header, or a line has another number of fields than the
/// header.
std::vector<CsvLine> read_csv(const std::filesystem::path& path);

}  // namespace piae::text
