#include "plan/changed_description.hpp"

#include <spdlog/fmt/fmt.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace piae::plan {

namespace {

std::optional<toml::table> parsed(const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

std::string value_text(const toml::node* node) {
  if (node == nullptr) return "not set";
  if (node->is_table()) return "a table";
  if (const auto* number = node->as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream text;
  node->visit([&](const auto& value) { text << value; });
  return text.str();
}

/// Returns the keys of both tables, each once.
std::set<std::string> keys_of_both(const toml::table& was, const toml::table& is) {
  std::set<std::string> keys;
  for (const auto& [key, node] : was) keys.emplace(key.str());
  for (const auto& [key, node] : is) keys.emplace(key.str());
  return keys;
}

std::string changed_node(const std::string& name, const toml::node* was, const toml::node* is);

std::string changed_in(const std::string& before, const toml::table& was, const toml::table& is) {
  for (const std::string& key : keys_of_both(was, is)) {
    std::string change = changed_node(before + key, was.get(key), is.get(key));
    if (!change.empty()) return change;
  }
  return {};
}

/// Compares two lists of tables entry by entry. Entries are counted from 1.
std::string changed_in(const std::string& name, const toml::array& was, const toml::array& is) {
  for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
    std::string change =
        changed_in(fmt::format("{} {}: ", name, i + 1), *was[i].as_table(), *is[i].as_table());
    if (!change.empty()) return change;
  }
  if (was.size() == is.size()) return {};
  return fmt::format("{} has {} entries, had {}", name, is.size(), was.size());
}

std::string changed_node(const std::string& name, const toml::node* was, const toml::node* is) {
  if (was != nullptr && is != nullptr) {
    if (was->is_table() && is->is_table()) {
      return changed_in(name + '.', *was->as_table(), *is->as_table());
    }
    if (was->is_array_of_tables() && is->is_array_of_tables()) {
      return changed_in(name, *was->as_array(), *is->as_array());
    }
  }
  const std::string before = value_text(was);
  const std::string now = value_text(is);
  return before == now ? "" : fmt::format("{} is {}, was {}", name, now, before);
}

}  // namespace

std::string changed_key(const std::string& was, const std::string& is) {
  const auto before = parsed(was);
  const auto now = parsed(is);
  return before && now ? changed_in("", *before, *now) : "";
}

}  // namespace piae::plan
