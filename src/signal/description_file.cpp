#include "signal/description_file.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "cli/toml_file.hpp"
#include "signal/bearing_table.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_node(const fs::path& file, const toml::node& node, const std::string& what,
                              Exit exit = Exit::bad_input) {
  const toml::source_region& place = node.source();
  throw Error(exit, one_line((place.path ? *place.path : file.string()) + ", line " +
                             std::to_string(place.begin.line) + ": " + what));
}

/// Returns the file named by `like`, if the description has one.
std::optional<fs::path> model_of(const fs::path& file, const toml::table& description) {
  const toml::node* like = description.get("like");
  if (like == nullptr) return std::nullopt;
  const auto name = like->value<std::string>();
  if (!name || !ranges::is_plain_name(*name)) {
    refuse_node(
        file, *like,
        "like must be the name of a description in the same folder, without its .toml; it " +
            ranges::plain_name_rule);
  }
  if (!description.contains("name")) {
    refuse_node(
        file, *like,
        "like is there, but name is missing; add a name that differs from the other description");
  }
  const fs::path model = file.parent_path() / (*name + ".toml");
  std::error_code unreadable;
  if (!fs::exists(model, unreadable)) {
    refuse_node(file, *like, "like = '" + *name + "', but there is no " + model.string(),
                Exit::input_missing);
  }
  return model;
}

/// Keys that decide the fault frequencies of a bearing.
enum class BearingBy { nothing, designation, dimensions, orders };

BearingBy decided_by(const toml::table& bearing) {
  const auto is_there = [&](const char* key) { return bearing.contains(key); };
  if (is_there("designation")) return BearingBy::designation;
  if (std::ranges::any_of(order_keys, is_there)) return BearingBy::orders;
  return std::ranges::any_of(geometry_keys, is_there) ? BearingBy::dimensions : BearingBy::nothing;
}

/// True if the description's own bearing takes nothing from its model's.
bool replaces_bearing(const toml::table& own, const toml::table& model) {
  const BearingBy by = decided_by(own);
  if (by == BearingBy::designation) return true;
  return by != BearingBy::nothing && by != decided_by(model);
}

/// Adds to `description` the keys of `model` that it lacks.
void complete(toml::table& description, toml::table& model) {
  for (auto&& [key, node] : model) {
    toml::node* own = description.get(key);
    if (own == nullptr) {
      description.insert(key, std::move(node));
    } else if (own->is_table() && node.is_table()) {
      toml::table& part = *own->as_table();
      const bool is_other = key.str() == "bearing" && replaces_bearing(part, *node.as_table());
      if (!is_other) complete(part, *node.as_table());
    }
  }
}

/// Reads a description with its models. `before` holds the files that led to it, to detect circles.
toml::table read_after(const std::vector<fs::path>& before, const fs::path& file) {
  toml::table description = cli::parse_toml_file(file);
  const auto model = model_of(file, description);
  if (!model) return description;
  std::vector<fs::path> so_far = before;
  so_far.push_back(file);
  if (std::ranges::find(so_far, *model) != so_far.end()) {
    refuse_node(file, *description.get("like"),
                "like forms a cycle: this description is like " + model->string() +
                    ", which is like this one; remove like from one of them");
  }
  description.erase("like");
  toml::table rest = read_after(so_far, *model);
  complete(description, rest);
  return description;
}

/// Replaces a designation by its keys from the table of bearings.
void complete_bearing(const fs::path& file, toml::table& description) {
  toml::table* const bearing = description["bearing"].as_table();
  const toml::node* const node = bearing != nullptr ? bearing->get("designation") : nullptr;
  if (node == nullptr) return;
  const auto designation = node->value<std::string>();
  if (!designation) refuse_node(file, *node, "bearing.designation must be a text in quotes");
  for (const std::span keys : {geometry_keys, std::span(order_keys)}) {
    for (const char* const key : keys) {
      const toml::node* const own = bearing->get(key);
      if (own == nullptr) continue;
      refuse_node(
          file, *own,
          fmt::format("bearing.{} is given, but designation decides it; remove one of the two",
                      key));
    }
  }
  try {
    for (const auto& [key, value] : bearing_called(*designation, bearing_table_of(file))) {
      if (key == "balls") {
        bearing->insert(key, static_cast<std::int64_t>(value));
      } else {
        bearing->insert(key, value);
      }
    }
  } catch (const Error& error) {
    refuse_node(file, *node, std::string("bearing.designation ") + error.what(), error.exit());
  }
  bearing->erase("designation");
}

}  // namespace

toml::table read_description_file(const fs::path& file) {
  toml::table description = read_after({}, file);
  complete_bearing(file, description);
  return description;
}

fs::path bearing_table_of(const fs::path& description) {
  return (description.parent_path() / ".." / "bearings.csv").lexically_normal();
}

}  // namespace piae::signal
