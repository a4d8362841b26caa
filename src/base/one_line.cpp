#include "base/one_line.hpp"

#include <array>
#include <cstdint>

namespace piae {

namespace {

constexpr std::size_t most_bytes = 1000;

/// First character of a text. A byte that is not valid UTF-8 counts as one character that is not
/// plain.
struct Character {
  std::size_t bytes;
  bool is_plain;
};

bool is_plain(std::uint32_t code) {
  const auto is_in = [code](std::uint32_t low, std::uint32_t high) {
    return code >= low && code <= high;
  };
  const bool is_command = is_in(0, 0x1f) || is_in(0x7f, 0x9f);
  const bool turns_lines =
      code == 0x61c || is_in(0x200e, 0x200f) || is_in(0x202a, 0x202e) || is_in(0x2066, 0x2069);
  const bool breaks_lines = is_in(0x2028, 0x2029);
  const bool is_character = code <= 0x10ffff && !is_in(0xd800, 0xdfff);
  return is_character && !is_command && !turns_lines && !breaks_lines;
}

/// Returns the length of a character in bytes by its first byte; 0 if no character starts with it.
std::size_t length_by(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc0) return 0;
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf8 ? 4 : 0;
}

Character first_of(std::string_view text) {
  constexpr Character bad{1, false};
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const auto byte = [text](std::size_t i) {
    return std::uint32_t{static_cast<unsigned char>(text[i])};
  };
  const std::size_t length = length_by(byte(0));
  if (length == 0 || length > text.size()) return bad;
  std::uint32_t code = length == 1 ? byte(0) : byte(0) & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return bad;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  // UTF-8 permits only the shortest form of a character.
  return code < least.at(length) ? bad : Character{length, is_plain(code)};
}

}  // namespace

bool has_control_characters(std::string_view text) {
  while (!text.empty()) {
    const Character first = first_of(text);
    if (!first.is_plain) return true;
    text.remove_prefix(first.bytes);
  }
  return false;
}

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const Character first = first_of(text);
    if (line.size() + first.bytes > most_bytes) return line + "...";
    line += first.is_plain ? text.substr(0, first.bytes) : "?";
    text.remove_prefix(first.bytes);
  }
  return line;
}

}  // namespace piae
