#include "raw/torn_decimals.hpp"

#include <algorithm>

#include "raw/csv_fields.hpp"

namespace piae::raw {

namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

/// Returns a number without its exponent.
std::string_view significand_of(std::string_view number) {
  return number.substr(0, std::min(number.find_first_of("eE"), number.size()));
}

}  // namespace

void TornDecimals::add(std::size_t line, std::string_view field, std::string_view next,
                       bool has_points) {
  if (!is_possible_) return;
  const std::string_view digits = significand_of(next);
  const bool is_time = field.find(':') != field.npos && is_date_or_time(field);
  is_possible_ = (is_time || (!has_points && is_digits(without_sign(field)))) && is_digits(digits);
  if (!is_possible_) return;
  has_one_length_ = has_one_length_ && (length_ == 0 || length_ == next.size());
  length_ = next.size();
  if (next.size() == 1) digits_.set(static_cast<std::size_t>(next.front() - '0'));
  const bool is_padded = digits.size() > 1 && digits.front() == '0';
  const bool is_scaled = digits.size() > 1 && digits.size() < next.size();
  last_ = {line, field, next};
  if (!evidence_ && (is_padded || is_scaled || field == "-0")) evidence_ = last_;
}

std::optional<TornDecimals::Evidence> TornDecimals::evidence() const {
  if (!is_possible_ || evidence_) return is_possible_ ? evidence_ : std::nullopt;
  return has_one_length_ && digits_.all() ? std::optional(last_) : std::nullopt;
}

}  // namespace piae::raw
