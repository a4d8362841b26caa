#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace piae::cli {

/// The most bytes of a file of settings, or of a description.
inline constexpr std::size_t most_toml_bytes = 1'000'000;

/// A text that is no TOML, or none that is read here: what is wrong, and in which line.
class NotToml : public std::runtime_error {
 public:
  NotToml(std::size_t line, const std::string& what) : std::runtime_error(what), line_(line) {}
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

/// Parses a TOML text. Throws NotToml, also where it is so large, or its tables are nested so
/// deeply, that the parser would take all memory for it. `source` is where it stands: each node
/// keeps it as source().path.
toml::table parse_toml(std::string_view text, std::string_view source = {});

}  // namespace piae::cli
