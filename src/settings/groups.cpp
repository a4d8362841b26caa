#include "settings/groups.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "settings/lists.hpp"
#include "signal/ranges.hpp"

namespace piae::settings {

namespace {

constexpr std::array<std::string_view, 4> keys{"datasets", "against", "inputs", "kind-inputs"};

/// Refuses a list that is missing, empty or has a repeated word.
void require_list(const std::filesystem::path& file, const toml::table& group,
                  const std::string& path, const std::string& key) {
  const std::string name = path + '.' + key;
  const toml::node* list = group.get(key);
  if (list == nullptr) refuse(file, group, "[" + path + "] has no list " + key);
  const bool has_words = list->is_array() && !list->as_array()->empty();
  if (!has_words) refuse(file, *list, name + " must be a list of words");
  std::set<std::string> words;
  for (const toml::node& node : *list->as_array()) {
    const auto word = node.value_or<std::string>("");
    if (!words.insert(word).second) refuse(file, node, holds(name, word, " twice"));
  }
}

std::string method_of_input(const std::filesystem::path& file, const toml::node& node,
                            const std::string& name) {
  try {
    return report::parse_input_choice(node.value_or<std::string>("")).method;
  } catch (const Error& error) {
    refuse(file, node, name + ": " + error.what());
  }
}

/// Requires valid inputs. Returns the methods that have an input.
std::set<std::string> require_inputs(const std::filesystem::path& file, const toml::table& group,
                                     const std::string& path, const std::string& key) {
  require_list(file, group, path, key);
  const std::string name = path + '.' + key;
  std::set<std::string> methods;
  for (const toml::node& node : *group.get(key)->as_array()) {
    const std::string method = method_of_input(file, node, name);
    if (!methods.insert(method).second) {
      refuse(file, node, fmt::format("{} names an input of {} twice", name, method));
    }
  }
  return methods;
}

/// Requires inputs for telling classes and, if the table has them, inputs for telling fault types,
/// which must name the same methods.
void require_both_inputs(const std::filesystem::path& file, const toml::table& group,
                         const std::string& path) {
  const std::set<std::string> methods = require_inputs(file, group, path, "inputs");
  const toml::node* kinds = group.get("kind-inputs");
  if (kinds == nullptr || require_inputs(file, group, path, "kind-inputs") == methods) return;
  refuse(file, *kinds,
         path + ".kind-inputs must name an input of each method of inputs, and no other");
}

void require_against(const std::filesystem::path& file, const toml::table& group,
                     const std::string& path) {
  const toml::node* own = group.get("against");
  const auto method = own == nullptr ? "" : own->value_or<std::string>("");
  if (augment::find_entry(method) != nullptr) return;
  refuse(file, own == nullptr ? group : *own,
         path + ".against must name a method, not '" + method + "'");
}

void require_group(const std::filesystem::path& file, const std::string& path,
                   const toml::table& group) {
  for (const auto& [key, node] : group) {
    if (node.is_table() || node.is_array_of_tables()) {
      refuse(file, node, "nothing reads the table [" + path + '.' + std::string(key.str()) + "]");
    }
    if (std::ranges::find(keys, key.str()) == keys.end()) {
      refuse(file, node,
             fmt::format("nothing reads {}.{}; a group has {}", path, key.str(),
                         fmt::join(keys, ", ")));
    }
  }
  require_list(file, group, path, "datasets");
  require_both_inputs(file, group, path);
  require_against(file, group, path);
}

}  // namespace

void require_groups(const std::filesystem::path& file, const toml::table& protocol) {
  const toml::table* groups = protocol["transfer"].as_table();
  if (groups == nullptr) return;
  for (const auto& [key, node] : *groups) {
    const std::string name(key.str());
    const std::string path = "transfer." + name;
    if (!node.is_table()) refuse(file, node, path + " is not in a group of data sets");
    if (!signal::ranges::is_plain_name(name)) {
      refuse(file, node, fmt::format("the name of [{}] {}", path, signal::ranges::plain_name_rule));
    }
    require_group(file, path, *node.as_table());
  }
}

std::vector<Group> groups(const toml::table& protocol) {
  std::vector<Group> groups;
  const toml::table* tables = protocol["transfer"].as_table();
  if (tables == nullptr) return groups;
  const auto inputs_in = [](const toml::table& table, const std::string& list) {
    std::vector<report::InputChoice> inputs;
    for (const std::string& word : words_in(table, list)) {
      inputs.push_back(report::parse_input_choice(word));
    }
    return inputs;
  };
  for (const auto& [key, node] : *tables) {
    const toml::table& table = *node.as_table();
    const std::string name(key.str());
    groups.push_back({.name = name,
                      .datasets = words_in(table, "datasets"),
                      .choices = {.group = name,
                                  .against = table["against"].value_or(std::string()),
                                  .inputs = inputs_in(table, "inputs"),
                                  .type_inputs = inputs_in(table, "kind-inputs")}});
  }
  return groups;
}

void require_datasets(const toml::table& protocol, const std::string& group,
                      const std::filesystem::path& pipeline) {
  const toml::array* datasets = protocol["transfer"][group]["datasets"].as_array();
  if (datasets == nullptr) return;
  for (const toml::node& node : *datasets) {
    const auto name = node.value_or<std::string>("");
    const std::filesystem::path description = pipeline / "datasets" / (name + ".toml");
    if (std::filesystem::exists(description)) continue;
    refuse(pipeline / "protocol.toml", node,
           holds("transfer." + group + ".datasets", name,
                 ", but there is no " + description.string()));
  }
}

}  // namespace piae::settings
