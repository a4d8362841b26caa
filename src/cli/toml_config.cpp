#include "cli/toml_config.hpp"

#include <toml++/toml.h>

#include <istream>
#include <sstream>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "cli/toml_options.hpp"
#include "cli/toml_text.hpp"

namespace piae::cli {

namespace {

std::string text_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  std::ostringstream out;
  out << toml::node_view<const toml::node>(node);
  return out.str();
}

std::vector<std::string> values_of(const toml::node& node) {
  std::vector<std::string> values;
  if (const auto* array = node.as_array()) {
    for (const toml::node& element : *array) values.push_back(text_of(element));
  } else {
    values.push_back(text_of(node));
  }
  return values;
}

/// What the stream holds, up to one byte more than parse_toml() takes.
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
