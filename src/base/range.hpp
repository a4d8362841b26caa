#pragma once

#include <string>

namespace piae {

/// Permitted values of a number, from `low` to `high`, both included; NaN is never permitted. Each
/// room keeps its ranges in one table (such as signal/ranges.hpp), which its descriptions, writers
/// and readers share.
struct Range {
  double low;
  double high;
  const char* unit = "";  ///< starts with a space

  [[nodiscard]] constexpr bool holds(double value) const { return value >= low && value <= high; }
  /// Returns a text such as "must be from 1 to 1e+07 Hz".
  [[nodiscard]] std::string rule() const;
};

}  // namespace piae
