#include "cli/one_line.hpp"

#include <algorithm>

namespace piae::cli {

namespace {

bool is_control_character(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

}  // namespace

bool has_control_characters(const std::string& text) {
  return std::ranges::any_of(text, is_control_character);
}

std::string one_line(std::string text) {
  std::ranges::replace_if(text, is_control_character, '?');
  return text;
}

}  // namespace piae::cli
