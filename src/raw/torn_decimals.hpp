#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace piae::raw {

/// Looks for decimal commas in lines whose fields are separated by commas: "0,-282,227" may be the
/// numbers 0 and -282.227, and "10:00:00,500" a time of day. Compares a field with the next one in
/// all lines. The next one may be the decimals of the first only if it is digits, maybe with an
/// exponent or a unit, but without a sign, and the first one is a whole number without leading
/// zeros, a sign alone, empty, or a time of day.
class TornDecimals {
 public:
  struct Evidence {
    std::size_t line = 0;
    std::string_view field;
    std::string_view next;
  };

  /// Adds a field and the next one of a line.
  void add(std::size_t line, std::string_view field, std::string_view next);
  /// Returns a line that is unlikely for whole numbers. In a table without a header and without
  /// decimal points, this is a -0 or a lone sign, or a next field such as 05, 12E-03 or 9E-01, or
  /// signed numbers whose next field is any single digit. In other tables, because programs do
  /// write some of these, only a pair of columns that has both a -0 and a next field such as 05.
  [[nodiscard]] std::optional<Evidence> evidence(bool has_name, bool has_points) const;
  /// True if the fields look like signed numbers and a fixed number of decimals.
  [[nodiscard]] bool may_be_decimals() const {
    return is_possible_ && has_one_length_ && has_sign_;
  }

 private:
  bool is_possible_ = true;
  bool is_time_ = false;
  bool has_sign_ = false;
  bool has_one_length_ = true;
  std::size_t length_ = 0;            ///< length of the next field; 0 before the first line
  std::optional<Evidence> negative_;  ///< first -0 or lone sign
  std::optional<Evidence> padded_;    ///< first next field with a leading zero
  std::optional<Evidence> scaled_;    ///< first next field with an exponent
  Evidence last_;
  std::bitset<10> digits_;  ///< digits that stood alone
};

}  // namespace piae::raw
