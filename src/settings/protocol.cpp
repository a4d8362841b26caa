#include "settings/protocol.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "settings/groups.hpp"
#include "settings/lists.hpp"

namespace piae::settings {

namespace {

/// The stages that read settings. `train` has a table for each method as well, `transfer` one for
/// each group of data sets.
const std::vector<std::string> stages = {"split",    "train", "generate", "score",    "diagnose",
                                         "tabulate", "sweep", "identify", "readings", "transfer"};

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

std::string nothing_reads(const std::string& path, const std::string& name,
                          const std::vector<std::string>& known) {
  return "nothing reads the table [" + path + name + "]" +
         (known.empty() ? "" : "; there are " + path + listed(known));
}

/// Refuses the tables in `parent` that are not among `known`. `path` is what their names begin
/// with.
void require_known_tables(const std::filesystem::path& file, const toml::table& parent,
                          const std::string& path, const std::vector<std::string>& known) {
  for (const auto& [key, node] : parent) {
    const std::string name(key.str());
    const bool is_table = node.is_table() || node.is_array_of_tables();
    if (is_table && (!node.is_table() || std::ranges::find(known, name) == known.end())) {
      refuse(file, node, nothing_reads(path, name, known));
    }
  }
}

/// Refuses a table of a method that is like one that is not there, or like one that is itself like
/// another.
void require_likeness(const std::filesystem::path& file, const toml::table& protocol,
                      const std::string& method, const toml::node& node) {
  try {
    (void)cli::options_of(protocol, "train", method);
  } catch (const Error& error) {
    refuse(file, node, error.what());
  }
}

/// The tables of methods in [train], none of which has a table itself.
void require_methods(const std::filesystem::path& file, const toml::table& protocol,
                     const toml::table& train) {
  for (const auto& [key, node] : train) {
    if (!node.is_table()) continue;
    const std::string method(key.str());
    require_known_tables(file, *node.as_table(), "train." + method + ".", {});
    require_likeness(file, protocol, method, node);
  }
}

struct Point {
  std::string factor;
  std::string value;
};

std::optional<Point> parse_point(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) return std::nullopt;
  return Point{word.substr(0, equals), word.substr(equals + 1)};
}

std::string twice(const std::string& factor) { return ", which sets " + factor + " twice"; }

/// Every word of the list is a point, or several that are joined by +, each of another factor; none
/// is there twice.
void require_points(const std::filesystem::path& file, const toml::table& protocol,
                    const std::string& table, const std::string& list) {
  const toml::node* points = protocol[table][list].node();
  if (points == nullptr) return;
  const std::string name = table + '.' + list;
  if (!points->is_array()) refuse(file, *points, name + " must be a list");
  std::set<std::string> words;
  for (const toml::node& node : *points->as_array()) {
    const auto word = node.value_or<std::string>("");
    if (!words.insert(word).second) refuse(file, node, holds(name, word, " twice"));
    std::istringstream parts(word + '+');
    std::set<std::string> factors;
    for (std::string part; std::getline(parts, part, '+');) {
      const auto point = parse_point(part);
      if (!point) refuse(file, node, holds(name, word, ", which is not FACTOR=VALUE"));
      if (!factors.insert(point->factor).second) {
        refuse(file, node, holds(name, word, twice(point->factor)));
      }
    }
  }
}

std::vector<std::string> words_of(const toml::table& protocol, const std::string& table,
                                  const std::string& list) {
  const toml::table* own = protocol[table].as_table();
  return own == nullptr ? std::vector<std::string>{} : words_in(*own, list);
}

bool is_value(const toml::node* node, const std::string& text) {
  if (node == nullptr) return false;
  if (node->is_number()) return node->value<double>() == number_in<double>(text);
  return node->value<std::string>() == text;
}

}  // namespace

toml::table read_protocol(const std::filesystem::path& file) {
  toml::table protocol = cli::parse_toml_file(file);
  for (const auto& [key, node] : protocol) {
    if (!node.is_table() && !node.is_array_of_tables()) {
      refuse(file, node, std::string(key.str()) + " stands in no table, so that no stage reads it");
    }
  }
  require_known_tables(file, protocol, "", stages);
  for (const auto& [key, node] : protocol) {
    const bool has_methods = key.str() == "train";
    if (key.str() == "transfer") continue;
    require_known_tables(file, *node.as_table(), std::string(key.str()) + ".",
                         has_methods ? augment::method_names() : std::vector<std::string>{});
    if (has_methods) require_methods(file, protocol, *node.as_table());
  }
  require_groups(file, protocol);
  require_points(file, protocol, "sweep", "points");
  require_points(file, protocol, "readings", "base");
  require_points(file, protocol, "readings", "readings");
  return protocol;
}

std::vector<std::string> sweep_points(const toml::table& protocol) {
  return words_of(protocol, "sweep", "points");
}

std::vector<std::string> readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "readings");
}

std::vector<std::string> base_of_readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "base");
}

std::vector<std::string> sweep_centre(const toml::table& protocol) {
  const toml::table options = cli::options_of(protocol, "train", augment::paper_method());
  std::vector<std::string> centre;
  for (const std::string& word : sweep_points(protocol)) {
    const Point point = *parse_point(word);
    if (is_value(options.get(point.factor), point.value)) centre.push_back(word);
  }
  return centre;
}

}  // namespace piae::settings
