#include "cli/toml_options.hpp"

#include <sstream>

#include "base/error.hpp"

namespace piae::cli {

namespace {

std::string text_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  std::ostringstream out;
  out << toml::node_view<const toml::node>(node);
  return out.str();
}

/// Takes the plain values of a table, without its tables.
void take_values(const toml::table& table, toml::table& options) {
  for (const auto& [key, node] : table) {
    if (!node.is_table() && !node.is_array_of_tables()) options.insert_or_assign(key, node);
  }
}

/// Takes the values of a variant's table, on top of those of the table that it is `like`.
void take_variant(const toml::table& program, const std::string& variant, toml::table& options) {
  const toml::table* own = program[variant].as_table();
  if (own == nullptr) return;
  if (own->contains("like")) {
    const auto name = (*own)["like"].value_or<std::string>("");
    const toml::table* other = program[name].as_table();
    if (other == nullptr || other->contains("like")) {
      throw Error(Exit::usage, "table of '" + variant + "': like = '" + name +
                                   "' must name a variant that has a table without like");
    }
    take_values(*other, options);
  }
  take_values(*own, options);
  options.erase("like");
}

}  // namespace

toml::table options_of(const toml::table& file, const std::string& program,
                       const std::string& variant) {
  const toml::table* own = file[program].as_table();
  toml::table options;
  take_values(own != nullptr ? *own : file, options);
  if (own != nullptr) take_variant(*own, variant, options);
  return options;
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

}  // namespace piae::cli
