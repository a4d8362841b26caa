#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "figures/numbers.hpp"
#include "figures/source.hpp"
#include "support/stored_run.hpp"

namespace piae::figures {

/// A stored run as the source of figures, with access to their CSV.
class StoredSource : public StoredRun {
 protected:
  [[nodiscard]] Source source(const std::string& methods, const std::string& ratios,
                              const std::string& seeds = "0 1") const {
    return {layout_, grid(methods, ratios, seeds), {}};
  }

  /// Returns field `column` of the only row that begins with these fields; "no row" if there is
  /// none.
  static std::string field(const Numbers& numbers, const std::string& beginning,
                           std::size_t column) {
    std::istringstream lines(numbers.csv());
    std::string found = "no row";
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(beginning + ",")) continue;
      EXPECT_EQ(found, "no row") << "several rows begin with " << beginning;
      found = fields_of(line).at(column);
    }
    return found;
  }

  static std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields{""};
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    return fields;
  }
};

}  // namespace piae::figures
