#include "cli/toml_text.hpp"

#include <algorithm>

namespace piae::cli {

namespace {

/// Each dot of a key is a table in a table, and the parser calls itself for each: with a hundred
/// thousand of them it crashes. It counts brackets by itself.
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

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view source) {
  if (text.size() > most_toml_bytes) throw NotToml(1, "is larger than 1 MB, which no settings are");
  require_shallow(text);
  try {
    return toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    throw NotToml(error.source().begin.line, "not valid TOML: " + std::string(error.description()));
  }
}

}  // namespace piae::cli
