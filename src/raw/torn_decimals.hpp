#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace piae::raw {

/// Looks for decimal commas in lines whose fields are separated by commas: "0,-282,227" may be the
/// numbers 0 and -282.227, and "10:00:00,500" a time of day. Compares a field with the next one in
/// all lines. The next one may be the decimals of the first only if it is digits without a sign,
/// and the first is a time of day, or a whole number in lines without decimal points.
class TornDecimals {
 public:
  /// Adds a field and the next one of a line. `has_points` is true if numbers have decimal points.
  void add(std::size_t line, std::string_view field, std::string_view next, bool has_points);
  struct Evidence {
    std::size_t line = 0;
    std::string_view field;
    std::string_view next;
  };
  /// Returns the first line whose fields programs do not write as whole numbers: a next field such
  /// as 05 or 123E-03, or a first field -0. If the next fields have one digit each and show all ten
  /// digits, returns the last line.
  [[nodiscard]] std::optional<Evidence> evidence() const;
  /// True if all next fields may be decimals of the same length.
  [[nodiscard]] bool may_be_decimals() const { return is_possible_ && has_one_length_ && length_ > 0; }

 private:
  bool is_possible_ = true;
  bool has_one_length_ = true;
  std::size_t length_ = 0;  ///< length of the next field; 0 before the first line
  std::optional<Evidence> evidence_;
  Evidence last_;
  std::bitset<10> digits_;  ///< digits that stood alone
};

}  // namespace piae::raw
