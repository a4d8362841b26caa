#include "raw/variable_path.hpp"

#include <string_view>

#include "base/numbers.hpp"

namespace piae::raw {

namespace {

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Returns a number that blanks may surround.
std::optional<std::size_t> number_between_blanks(std::string_view text) {
  return number_in<std::size_t>(without_blanks(text));
}

/// Takes the text in brackets from the end of a text; returns nothing if it does not end in
/// brackets.
std::optional<std::string> take_brackets(std::string& text, char open, char close) {
  const std::size_t begin = text.find(open);
  if (begin == std::string::npos || text.back() != close) return std::nullopt;
  std::string inside = text.substr(begin + 1, text.size() - begin - 2);
  text.resize(begin);
  return inside;
}

std::optional<PathStep> parse_step(std::string text) {
  PathStep step;
  if (const auto condition = take_brackets(text, '[', ']')) {
    const std::size_t equals = condition->find('=');
    if (equals == std::string::npos || equals == 0) return std::nullopt;
    step.key = condition->substr(0, equals);
    step.value = condition->substr(equals + 1);
  }
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'{', '}'}}) {
    const auto number = take_brackets(text, open, close);
    if (!number) continue;
    const std::string_view inside = *number;
    const std::size_t comma = inside.find(',');
    step.number = number_between_blanks(inside.substr(0, comma)).value_or(0);
    if (step.number == 0 || !step.key.empty()) return std::nullopt;
    if (comma == std::string_view::npos) continue;
    step.column = number_between_blanks(inside.substr(comma + 1)).value_or(0);
    if (step.column == 0) return std::nullopt;
  }
  if (text.empty() || text.find_first_of("[](){}=") != std::string::npos) return std::nullopt;
  step.name = std::move(text);
  return step;
}

/// Returns the parts between points outside brackets.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts{""};
  bool in_brackets = false;
  for (const char c : text) {
    if (c == '[') in_brackets = true;
    if (c == ']') in_brackets = false;
    if (c == '.' && !in_brackets) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

std::optional<MatrixLine> take_matrix_line(std::string& text) {
  const std::size_t begin = text.rfind('(');
  if (begin == std::string::npos || !text.ends_with(')')) return std::nullopt;
  const std::string inside = text.substr(begin + 1, text.size() - begin - 2);
  const std::string_view both = inside;
  const std::size_t comma = both.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view row = without_blanks(both.substr(0, comma));
  const std::string_view column = without_blanks(both.substr(comma + 1));
  const bool is_row = column == ":";
  if (!is_row && row != ":") return std::nullopt;
  const auto number = number_in<std::size_t>(is_row ? row : column);
  if (!number || *number == 0) return std::nullopt;
  text.resize(begin);
  return MatrixLine{is_row, *number};
}

std::string hint_at_parts(const std::string& name) {
  if (name.find_first_of("([{") == std::string::npos) return "";
  return "; write a row as data(1,:), a column as data(:,1), an element as c{1} or s(1).x, counted "
         "from 1";
}

std::optional<VariablePath> parse_variable(const std::string& text) {
  std::string rest = text;
  VariablePath path{.steps = {}, .line = take_matrix_line(rest)};
  for (const std::string& part : parts_of(rest)) {
    auto step = parse_step(part);
    if (!step) return std::nullopt;
    path.steps.push_back(std::move(*step));
  }
  return path;
}

}  // namespace piae::raw
