#include "settings/protocol.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "cli/setting.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/diagnosis_record.hpp"
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
  const std::string name = table + '.' + list;
  const toml::node* points = protocol.at_path(name).node();
  if (points == nullptr) return;
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
  const toml::table* own = protocol.at_path(table).as_table();
  return own == nullptr ? std::vector<std::string>{} : words_in(*own, list);
}

bool is_value(const toml::node* node, const std::string& text) {
  if (node == nullptr) return false;
  if (node->is_number()) return node->value<double>() == number_in<double>(text);
  return node->value<std::string>() == text;
}

/// The methods that may have a table in [sweep], whose own values are of the paper's method. A
/// ceiling is no method.
std::vector<std::string> others_that_are_swept() {
  std::vector<std::string> methods = augment::method_names();
  std::erase_if(methods, [](const std::string& method) {
    return method == augment::paper_method() || augment::is_ceiling(method);
  });
  return methods;
}

std::string sweep_table(const std::string& method) {
  return method == augment::paper_method() ? "sweep" : "sweep." + method;
}

/// A table of a sweep holds nothing but its points and, where it is not the paper's, its
/// classifier.
void require_sweep_keys(const std::filesystem::path& file, const toml::table& table,
                        const std::string& name, bool has_classifier) {
  for (const auto& [key, node] : table) {
    const bool is_known = key.str() == "points" || (has_classifier && key.str() == "classifier");
    if (!is_known && !node.is_table()) {
      refuse(file, node, "nothing reads " + name + "." + std::string(key.str()));
    }
  }
  if (has_classifier && !table.contains("points")) refuse(file, table, name + " has no points");
}

/// Every point is an option of the method, with a value that it takes.
void require_options(const std::filesystem::path& file, const toml::array& points,
                     const std::string& list, const std::string& method) {
  for (const toml::node& node : points) {
    const auto word = node.value_or<std::string>("");
    const Point point = *parse_point(word);
    const auto made = augment::make_method(method);
    const auto bind = [&](const cli::Options& options) { made->bind(options); };
    const std::string refusal = cli::refusal_of(bind, point.factor, point.value);
    if (!refusal.empty())
      refuse(file, node, holds(list, word, ", but of " + method + ' ' + refusal));
  }
}

void require_classifier(const std::filesystem::path& file, const toml::node& node) {
  try {
    diagnosis::the_classifier(node.value_or<std::string>(""));
  } catch (const Error& error) {
    refuse(file, node, error.what());
  }
}

void require_sweep(const std::filesystem::path& file, const toml::table& protocol,
                   const std::string& method) {
  const std::string name = sweep_table(method);
  const toml::table* const table = protocol.at_path(name).as_table();
  if (table == nullptr) return;
  require_sweep_keys(file, *table, name, method != augment::paper_method());
  require_points(file, protocol, name, "points");
  const toml::array* const points = (*table)["points"].as_array();
  if (points != nullptr) require_options(file, *points, name + ".points", method);
  const toml::node* const classifier = table->get("classifier");
  if (classifier != nullptr) require_classifier(file, *classifier);
}

/// The methods that may have tables of their own in that of a stage.
std::vector<std::string> methods_with_tables(const std::string& stage) {
  if (stage == "train") return augment::method_names();
  if (stage == "sweep") return others_that_are_swept();
  return {};
}

Sweep sweep_of(const toml::table& protocol, const std::string& method) {
  const std::string name = sweep_table(method);
  Sweep sweep{
      .method = method,
      .classifier = protocol.at_path(name + ".classifier").value_or(scoring::paper_classifier),
      .points = words_of(protocol, name, "points"),
      .centre = {}};
  const toml::table options = cli::options_of(protocol, "train", method);
  for (const std::string& word : sweep.points) {
    const Point point = *parse_point(word);
    if (is_value(options.get(point.factor), point.value)) sweep.centre.push_back(word);
  }
  return sweep;
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
    const std::string stage(key.str());
    if (stage == "transfer") continue;
    require_known_tables(file, *node.as_table(), stage + ".", methods_with_tables(stage));
    if (stage == "train") require_methods(file, protocol, *node.as_table());
  }
  require_groups(file, protocol);
  require_sweep(file, protocol, augment::paper_method());
  for (const std::string& method : others_that_are_swept()) require_sweep(file, protocol, method);
  require_points(file, protocol, "readings", "base");
  require_points(file, protocol, "readings", "readings");
  return protocol;
}

std::vector<Sweep> sweeps(const toml::table& protocol) {
  std::vector<Sweep> all{sweep_of(protocol, augment::paper_method())};
  for (const std::string& method : others_that_are_swept()) {
    all.push_back(sweep_of(protocol, method));
  }
  std::erase_if(all, [](const Sweep& sweep) { return sweep.points.empty(); });
  return all;
}

std::vector<std::string> readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "readings");
}

std::vector<std::string> base_of_readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "base");
}

}  // namespace piae::settings
