#include "raw/csv_fields.hpp"

#include <algorithm>
#include <array>

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

std::optional<double> number_in_field(std::string_view field, char separator) {
  const bool has_plus = field.size() > 1 && field.front() == '+' && field[1] != '-';
  if (has_plus) field.remove_prefix(1);
  const auto number = number_in<double>(field);
  const std::size_t comma = field.find(',');
  if (number || separator == ',' || comma == std::string_view::npos) return number;
  constexpr std::size_t longest = 64;
  if (field.size() > longest || field.find('.') != std::string_view::npos) return std::nullopt;
  std::array<char, longest> point{};
  std::ranges::copy(field, point.begin());
  point.at(comma) = '.';
  return number_in<double>({point.data(), field.size()});
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
