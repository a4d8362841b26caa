#include "cli/toml_text.hpp"

#include <algorithm>

#include "cli/toml_advice.hpp"

namespace piae::cli {

namespace {

/// The parser recurses for each dot of a key and crashes at a hundred thousand of them. It limits
/// the depth of brackets itself.
constexpr std::ptrdiff_t most_dots = 100;

void require_shallow(std::string_view text) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (std::ranges::count(line, '.') > most_dots) {
      throw NotToml(number, "has more than " + std::to_string(most_dots) +
                                " dots; break it into several lines");
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

/// Returns a line by its number, counted from 1.
std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1 && !text.empty(); --number) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view source) {
  if (text.size() > most_toml_bytes) {
    throw NotToml(1, "is larger than 1 MB, the limit for settings");
  }
  require_shallow(text);
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    const std::size_t line = error.source().begin.line;
    const std::string advice = toml_advice(line_of(text, line));
    throw NotToml(
        line, "not valid TOML: " + (advice.empty() ? std::string(error.description()) : advice));
  }
}

}  // namespace piae::cli
