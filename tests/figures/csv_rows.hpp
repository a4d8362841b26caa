#pragma once

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "figures/numbers.hpp"

namespace piae::figures {

/// Rows of a figure's CSV, with fields by column name.
class CsvRows {
 public:
  using Row = std::map<std::string, std::string>;

  explicit CsvRows(const Numbers& numbers) {
    std::istringstream lines(numbers.csv());
    std::string line;
    std::getline(lines, line);
    header_ = fields(line);
    while (std::getline(lines, line)) {
      const std::vector<std::string> values = fields(line);
      Row& row = rows_.emplace_back();
      for (std::size_t i = 0; i < header_.size(); ++i) row[header_[i]] = values.at(i);
    }
  }

  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }

  /// Returns the rows with these values.
  [[nodiscard]] std::vector<Row> where(const Row& wanted) const {
    std::vector<Row> found;
    for (const Row& row : rows_) {
      const auto fits = [&](const auto& each) { return row.at(each.first) == each.second; };
      if (std::ranges::all_of(wanted, fits)) found.push_back(row);
    }
    return found;
  }

 private:
  static std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> all(1);
    for (const char c : line) {
      if (c == ',') {
        all.emplace_back();
      } else {
        all.back() += c;
      }
    }
    return all;
  }

  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

}  // namespace piae::figures
