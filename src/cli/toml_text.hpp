#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace piae::cli {

/// Largest size of a file of settings or a description, in bytes.
inline constexpr std::size_t most_toml_bytes = 1'000'000;

/// Thrown for a text that is not valid TOML or is not accepted here: the problem and its line.
class NotToml : public std::runtime_error {
 public:
  NotToml(std::size_t line, const std::string& what) : std::runtime_error(what), line_(line) {}
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

/// Parses a TOML text. Throws NotToml, also if the text is so large or so deeply nested that the
/// parser would run out of memory. Each node keeps `source` as source().path.
toml::table parse_toml(std::string_view text, std::string_view source = {});

}  // namespace piae::cli
