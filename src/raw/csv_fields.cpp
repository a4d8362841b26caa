#include "raw/csv_fields.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/numbers.hpp"

namespace piae::raw {

namespace {

/// True if a text is several numbers with blanks between them. A field between two commas is such a
/// text if blanks are the separators.
bool is_numbers_apart(std::string_view text) {
  text = trimmed(text, blanks);
  if (text.find_first_of(blanks) == std::string_view::npos) return false;
  for (std::optional rest = text; rest;) {
    if (!number_in<double>(take_field(rest, ' '))) return false;
  }
  return true;
}

}  // namespace

std::optional<double> number_in_field(std::string_view field) {
  const bool has_plus = field.size() > 1 && field.front() == '+' && field[1] != '-';
  if (has_plus) field.remove_prefix(1);
  const auto number = number_in<double>(field);
  const std::size_t comma = field.find(',');
  if (number || comma == std::string_view::npos) return number;
  constexpr std::size_t longest = 64;
  if (field.size() > longest || field.find('.') != std::string_view::npos) return std::nullopt;
  std::array<char, longest> point{};
  std::ranges::copy(field, point.begin());
  point.at(comma) = '.';
  return number_in<double>({point.data(), field.size()});
}

bool is_date_or_time(std::string_view text) {
  const auto count = [&](std::string_view signs) {
    return std::ranges::count_if(text,
                                 [&](char c) { return signs.find(c) != std::string_view::npos; });
  };
  const auto digits = count("0123456789");
  const auto others = count(count(":") >= 2 ? ".:/- ,+TZAPM" : ".:/- ");
  return digits >= 5 && digits + others == static_cast<std::ptrdiff_t>(text.size()) &&
         (count(":/") >= 1 || count(".") == 2 || count("-") == 2);
}

void Decimals::add(std::size_t line, std::string_view number) {
  last_ = {line, number};
  ++by_size_.at(std::min(number.size(), by_size_.size() - 1));
  const std::size_t sign = number.find_first_of(".,");
  last_length_ = sign == std::string_view::npos ? 0 : number.size() - sign - 1;
  if (sign != std::string_view::npos) {
    if (alike_ == 0) length_ = last_length_;
    ++(last_length_ == length_ ? alike_ : others_);
    const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
    has_zero_end_ = has_zero_end_ || (exponent > sign + 1 && number[exponent - 1] == '0');
    return;
  }
  const std::string_view digits = trimmed(number, "+-");
  if (digits.find_first_not_of("0123456789") != std::string_view::npos) {  // NaN, 1e5
    last_length_ = length_;
    return;
  }
  if (digits.find_first_not_of('0') == std::string_view::npos) {
    ++zeros_;
  } else if (wholes_++ == 0) {
    first_whole_ = last_;
  }
}

std::optional<Decimals::Number> Decimals::whole_number() const {
  const bool is_fixed = length_ >= 2 && others_ == 0 && has_zero_end_;
  const bool are_rare = wholes_ > 0 && alike_ >= enough * wholes_;
  return is_fixed && are_rare ? std::optional(first_whole_) : std::nullopt;
}

std::optional<Decimals::Number> Decimals::short_end() const {
  const bool is_alone = others_ + wholes_ + zeros_ == 1;
  const bool is_short = last_length_ < length_ && alike_ >= enough;
  return is_alone && is_short ? std::optional(last_) : std::nullopt;
}

bool Decimals::has_rare_end() const {
  constexpr std::size_t rare = 20;  // one number in so many
  const std::size_t size = std::min(last_.text.size(), by_size_.size() - 1);
  const auto* const longer = by_size_.begin() + size + 1;
  const std::size_t short_ones = std::accumulate(by_size_.begin(), longer, std::size_t{0});
  const std::size_t long_ones = std::accumulate(longer, by_size_.end(), std::size_t{0});
  return short_ones + long_ones >= enough && long_ones >= (rare - 1) * short_ones;
}

char separator_of(std::string_view line) {
  for (const char candidate : {';', '\t', '|'}) {
    if (line.find(candidate) != std::string_view::npos) return candidate;
  }
  if (line.find(',') != std::string_view::npos) {
    // "0,1 2,5" are two numbers with decimal commas.
    for (std::optional rest = line; rest;) {
      const std::size_t end = rest->find(',');
      if (is_numbers_apart(rest->substr(0, end))) return ' ';
      rest = end == std::string_view::npos ? std::nullopt : std::optional(rest->substr(end + 1));
    }
    return ',';
  }
  const bool apart = trimmed(line, blanks).find_first_of(blanks) != std::string_view::npos;
  return apart ? ' ' : ',';
}

}  // namespace piae::raw
