#pragma once

#include <string>

namespace piae {

/// What a number may be: from `low` to `high`, both included. A NaN is in no range. The ranges of a
/// room stand in one table (signal/ranges.hpp and the like), by which its descriptions, its writers
/// and its readers go alike.
struct Range {
  double low;
  double high;
  const char* unit = "";  ///< with a space before it

  [[nodiscard]] constexpr bool holds(double value) const { return value >= low && value <= high; }
  /// "must be from 1 to 1e+07 Hz".
  [[nodiscard]] std::string rule() const;
};

}  // namespace piae
