#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::text {

/// One line of comma-separated values (RFC 4180, but ended by a line feed alone): a field with a
/// comma, a quote or a line feed in it is quoted.
std::string csv_line(const std::vector<std::string>& fields);

/// A line of a CSV file, and where it stands.
struct CsvLine {
  std::string place;  ///< "table6-7-baseline.csv, line 3"
  std::vector<std::string> fields;

  /// Throws Error(bad_input) with the place.
  [[noreturn]] void refuse(const std::string& what) const;
  /// Field i as a number; empty where it is not a finite one.
  [[nodiscard]] std::optional<double> number(std::size_t i) const;
};

/// Reads all lines of a file but comments (#) and empty lines. The first is the header. Quotes in
/// fields are not understood. Throws Error(input_missing) for a file that cannot be read, and
/// Error(bad_input) for a file without a line below the header and for a line that has more or
/// fewer fields than the header.
std::vector<CsvLine> read_csv(const std::filesystem::path& path);

}  // namespace piae::text
