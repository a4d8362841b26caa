#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "text/csv.hpp"

namespace piae::figures {

/// A table of a run, a CSV file that another stage wrote, with its columns found by name.
class StoredTable {
 public:
  /// Throws as text::read_csv does.
  explicit StoredTable(const std::filesystem::path& path)
      : path_(path), lines_(text::read_csv(path)) {}

  /// Returns the number of rows below the header.
  [[nodiscard]] std::size_t rows() const { return lines_.size() - 1; }
  /// Throws Error(bad_input) without such a column.
  [[nodiscard]] const std::string& at(std::size_t row, const std::string& column) const;

 private:
  std::filesystem::path path_;
  std::vector<text::CsvLine> lines_;
};

}  // namespace piae::figures
