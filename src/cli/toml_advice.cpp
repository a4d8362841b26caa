#include "cli/toml_advice.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/numbers.hpp"

namespace piae::cli {

namespace {

constexpr std::size_t longest_shown = 80;

std::string_view without_blanks(std::string_view text) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_quotes(std::string_view text) {
  // Single quotes keep backslashes as they are.
  const char quote = text.find('\\') == std::string_view::npos ? '"' : '\'';
  return quote + std::string(text) + quote;
}

bool is_value(std::string_view text) {
  try {
    (void)toml::parse("value = " + std::string(text) + "\n");
    return true;
  } catch (const toml::parse_error&) {
    return false;
  }
}

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Returns 1,5 as 1.5; empty if the value is not a number with a decimal comma.
std::string with_decimal_point(std::string_view value) {
  std::string number(value);
  if (std::ranges::count(number, ',') != 1) return {};
  std::ranges::replace(number, ',', '.');
  return number_in<double>(number) ? number : std::string();
}

/// Returns the first element of a list that is not a value; empty if all are.
std::string_view bad_element(std::string_view list) {
  if (!list.starts_with('[') || !list.ends_with(']')) return {};
  std::string_view rest = list.substr(1, list.size() - 2);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    const std::string_view element = without_blanks(rest.substr(0, end));
    if (!element.empty() && !is_value(element)) return element;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

std::string advice_on_value(std::string_view value) {
  if (value.empty()) return "has no value";
  if (has(value, "“") || has(value, "”") || has(value, "„") || has(value, "‘") || has(value, "’")) {
    return "has curly quotes; write straight ones, \"...\"";
  }
  const bool is_quoted = value.front() == '"' || value.front() == '\'';
  if (is_quoted) {
    const bool ends = value.size() > 1 && value.back() == value.front();
    if (!ends) return "has a text in quotes without an end, or something after it";
    if (value.front() == '"' && has(value, "\\")) {
      return "has a backslash in the text; write it between single quotes, '...', or replace it by "
             "/";
    }
    return {};
  }
  const std::string number = with_decimal_point(value);
  if (!number.empty()) return "has a decimal comma; write " + number;
  if (const std::string_view element = bad_element(value); !element.empty()) {
    return "has " + std::string(element) + " without quotes; write " + in_quotes(element);
  }
  const bool is_plain = value.find_first_of("[]{}\"'") == std::string_view::npos;
  if (!is_plain) return {};
  const bool is_like_a_number = value.find_first_not_of("0123456789+-._eE") == std::string::npos;
  if (is_like_a_number) return {};
  const bool begins_like_a_number = value.find_first_of("0123456789+-.") == 0;
  if (begins_like_a_number && has(value, " ")) {
    return "has something after the number; remove it, or write a text in quotes, " +
           in_quotes(value);
  }
  return "is a text without quotes; write " + in_quotes(value);
}

/// Returns a line without its comment. A # in quotes does not start a comment.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == 0 && c == '#') return line.substr(0, i);
    if (c != '"' && c != '\'') continue;
    if (quote == 0) {
      quote = c;
    } else if (quote == c) {
      quote = 0;
    }
  }
  return line;
}

}  // namespace

std::string toml_advice(std::string_view line) {
  line = without_blanks(without_comment(line));
  const std::size_t equals = line.find('=');
  if (line.empty() || line.starts_with('[') || line.size() > longest_shown) return {};
  if (equals == std::string_view::npos) {
    const std::size_t blank = line.find_first_of(" \t:");
    if (blank == std::string_view::npos) return {};
    return "has no equals sign; a line is KEY = VALUE";
  }
  const std::string_view key = without_blanks(line.substr(0, equals));
  const std::string_view value = without_blanks(line.substr(equals + 1));
  if (is_value(value)) return {};
  const std::string advice = advice_on_value(value);
  return advice.empty() ? "" : std::string(key) + " " + advice;
}

}  // namespace piae::cli
