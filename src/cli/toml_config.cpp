#include "cli/toml_config.hpp"

#include <toml++/toml.h>

#include <map>
#include <sstream>

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

using Values = std::map<std::string, std::vector<std::string>>;

/// Takes the values of a table, but not the tables in it.
void take_values(const toml::table& table, Values& values) {
  for (const auto& [key, node] : table) {
    if (!node.is_table() && !node.is_array_of_tables()) {
      values[std::string(key.str())] = values_of(node);
    }
  }
}

/// Takes the values of a variant's table, after those of the variant that it is `like`.
void take_variant(const toml::table& program, const std::string& variant, Values& values) {
  const toml::table* own = program[variant].as_table();
  if (own == nullptr) return;
  if (own->contains("like")) {
    const auto name = (*own)["like"].value_or<std::string>("");
    const toml::table* other = program[name].as_table();
    if (other == nullptr || other->contains("like")) {
      throw CLI::ConfigError("table of '" + variant + "': like = '" + name +
                             "' must name a variant that has a table and is itself like none");
    }
    take_values(*other, values);
  }
  take_values(*own, values);
  values.erase("like");
}

}  // namespace

std::vector<CLI::ConfigItem> TomlConfig::from_config(std::istream& input) const {
  toml::table file;
  try {
    file = toml::parse(input);
  } catch (const toml::parse_error& error) {
    std::ostringstream line;
    line << "not valid TOML: " << error.description() << " (line " << error.source().begin.line
         << ")";
    throw CLI::ConfigError(line.str());
  }
  const toml::table* table = file[program_].as_table();
  Values values;
  take_values(table != nullptr ? *table : file, values);
  if (table != nullptr) take_variant(*table, variant_, values);
  std::vector<CLI::ConfigItem> items;
  for (auto& [name, inputs] : values) items.push_back({{}, name, std::move(inputs)});
  return items;
}

}  // namespace piae::cli
