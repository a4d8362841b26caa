#include "raw/torn_decimals.hpp"

#include <algorithm>

#include "raw/csv_fields.hpp"

namespace piae::raw {

namespace {

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

bool is_padded(std::string_view digits) { return digits.size() > 1 && digits.front() == '0'; }

bool is_time_of_day(std::string_view text) {
  return text.find(':') != text.npos && is_date_or_time(text);
}

/// True if a text may stand before a decimal comma.
bool may_precede_decimals(std::string_view field) {
  const std::string_view whole = without_sign(field);
  return whole.empty() || (is_digits(whole) && !is_padded(whole)) || is_time_of_day(field);
}

/// Returns a number without the unit behind it.
std::string_view without_unit(std::string_view field) {
  return field.substr(0, std::min(field.find(' '), field.size()));
}

/// Returns a number without its exponent.
std::string_view significand_of(std::string_view number) {
  return number.substr(0, std::min(number.find_first_of("eE"), number.size()));
}

}  // namespace

void TornDecimals::add(std::size_t line, std::string_view field, std::string_view next) {
  if (!is_possible_) return;
  const std::string_view number = without_unit(next);
  const std::string_view digits = significand_of(number);
  is_possible_ = may_precede_decimals(field) && is_digits(digits);
  if (!is_possible_) return;
  last_ = {line, field, next};
  is_time_ = is_time_of_day(field);
  const std::string_view whole = without_sign(field);
  has_sign_ = has_sign_ || whole.size() < field.size();
  has_one_length_ = has_one_length_ && (length_ == 0 || length_ == number.size());
  length_ = number.size();
  if (number.size() == 1) digits_.set(static_cast<std::size_t>(number.front() - '0'));
  const bool is_small = number.find("e-") != number.npos || number.find("E-") != number.npos;
  const bool is_scaled = digits.size() < number.size() && (digits.size() > 1 || is_small);
  if (!negative_ && (field == "-0" || (whole.empty() && !field.empty()))) negative_ = last_;
  if (!padded_ && is_padded(digits)) padded_ = last_;
  if (!scaled_ && is_scaled) scaled_ = last_;
}

std::optional<TornDecimals::Evidence> TornDecimals::evidence(bool has_name, bool has_points) const {
  if (!is_possible_) return std::nullopt;
  if (negative_ && padded_) return negative_->line < padded_->line ? negative_ : padded_;
  if (has_name || (has_points && !is_time_)) return std::nullopt;
  for (const auto& found : {negative_, padded_, scaled_}) {
    if (found) return found;
  }
  return may_be_decimals() && digits_.all() ? std::optional(last_) : std::nullopt;
}

}  // namespace piae::raw
