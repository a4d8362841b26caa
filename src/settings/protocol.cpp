#include "settings/protocol.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "report/sweep.hpp"

namespace piae::settings {

namespace {

/// The stages that read settings. `train` has a table for each method as well.
const std::vector<std::string> stages = {"split",    "train",    "generate", "score",
                                         "diagnose", "tabulate", "sweep",    "identify"};

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const toml::node& node,
                         const std::string& what) {
  std::ostringstream line;
  line << file.string() << ", line " << node.source().begin.line << ": " << what;
  throw Error(Exit::bad_input, line.str());
}

/// Refuses the tables in `parent` that are not among `known`. `path` is what their names begin
/// with.
void require_known_tables(const std::filesystem::path& file, const toml::table& parent,
                          const std::string& path, const std::vector<std::string>& known) {
  for (const auto& [key, node] : parent) {
    const std::string name(key.str());
    const bool is_table = node.is_table() || node.is_array_of_tables();
    if (is_table && (!node.is_table() || std::ranges::find(known, name) == known.end())) {
      refuse(file, node,
             "nothing reads the table [" + path + name + "]" +
                 (known.empty() ? "" : "; there are " + path + listed(known)));
    }
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

void require_points(const std::filesystem::path& file, const toml::table& protocol) {
  const toml::node* points = protocol["sweep"]["points"].node();
  if (points == nullptr) return;
  if (!points->is_array()) refuse(file, *points, "sweep.points must be a list");
  for (const toml::node& node : *points->as_array()) {
    const auto word = node.value_or<std::string>("");
    if (!parse_point(word)) {
      refuse(file, node, "sweep.points holds '" + word + "', which is not FACTOR=VALUE");
    }
  }
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
    require_known_tables(file, *node.as_table(), std::string(key.str()) + ".",
                         has_methods ? augment::method_names() : std::vector<std::string>{});
    if (!has_methods) continue;
    for (const auto& [method, table] : *node.as_table()) {
      if (table.is_table()) {
        require_known_tables(file, *table.as_table(), "train." + std::string(method.str()) + ".",
                             {});
      }
    }
  }
  require_points(file, protocol);
  return protocol;
}

std::vector<std::string> sweep_points(const toml::table& protocol) {
  std::vector<std::string> points;
  const toml::array* words = protocol["sweep"]["points"].as_array();
  if (words == nullptr) return points;
  for (const toml::node& node : *words) points.push_back(node.value_or<std::string>(""));
  return points;
}

std::vector<std::string> sweep_centre(const toml::table& protocol) {
  const toml::table options = cli::options_of(protocol, "train", report::swept_method);
  std::vector<std::string> centre;
  for (const std::string& word : sweep_points(protocol)) {
    const Point point = *parse_point(word);
    if (is_value(options.get(point.factor), point.value)) centre.push_back(word);
  }
  return centre;
}

}  // namespace piae::settings
