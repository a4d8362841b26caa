#include "cli/toml_config.hpp"

#include <toml++/toml.h>

#include <istream>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "cli/toml_options.hpp"
#include "cli/toml_text.hpp"

namespace piae::cli {

namespace {

/// Returns the contents of the stream, at most one byte more than parse_toml() accepts.
std::string beginning_of(std::istream& input) {
  std::string text(most_toml_bytes + 1, '\0');
  input.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (input.bad()) throw CLI::ConfigError("cannot be read");
  text.resize(static_cast<std::size_t>(input.gcount()));
  return text;
}

}  // namespace

std::vector<CLI::ConfigItem> TomlConfig::from_config(std::istream& input) const {
  const std::string text = beginning_of(input);
  std::vector<CLI::ConfigItem> items;
  try {
    for (const auto& [key, node] : options_of(parse_toml(text), program_, variant_)) {
      items.push_back({{}, std::string(key.str()), values_of(node)});
    }
  } catch (const NotToml& error) {
    throw CLI::ConfigError(one_line("line " + std::to_string(error.line()) + ": " + error.what()));
  } catch (const Error& error) {
    throw CLI::ConfigError(error.what());
  }
  return items;
}

}  // namespace piae::cli
