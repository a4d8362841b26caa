#include "settings/sweeps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "cli/toml_options.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/diagnosis_record.hpp"
#include "settings/lists.hpp"
#include "settings/method_options.hpp"
#include "settings/points.hpp"

namespace piae::settings {

namespace {

bool is_value(const toml::node* node, const std::string& text) {
  if (node == nullptr) return false;
  if (node->is_number()) return node->value<double>() == number_in<double>(text);
  return node->value<std::string>() == text;
}

std::string sweep_table(const std::string& method) {
  return method == augment::paper_method() ? "sweep" : "sweep." + method;
}

/// Refuses keys of a sweep's table other than its points and, except for the paper's method, its
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

/// Requires that every point is an option of the method, with a valid value.
void require_options(const std::filesystem::path& file, const toml::array& points,
                     const std::string& list, const std::string& method) {
  for (const toml::node& node : points) {
    const auto word = node.value_or<std::string>("");
    const Point point = *parse_point(word);
    const std::string refusal = refusal_of(method, point);
    if (!refusal.empty()) refuse(file, node, holds(list, word, ", which " + refusal));
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

std::vector<std::string> others_that_are_swept() {
  std::vector<std::string> methods = augment::method_names();
  std::erase_if(methods, [](const std::string& method) {
    return method == augment::paper_method() || augment::is_ceiling(method);
  });
  return methods;
}

std::vector<Sweep> sweeps(const toml::table& protocol) {
  std::vector<Sweep> all{sweep_of(protocol, augment::paper_method())};
  for (const std::string& method : others_that_are_swept()) {
    all.push_back(sweep_of(protocol, method));
  }
  std::erase_if(all, [](const Sweep& sweep) { return sweep.points.empty(); });
  return all;
}

void require_sweeps(const std::filesystem::path& file, const toml::table& protocol) {
  require_sweep(file, protocol, augment::paper_method());
  for (const std::string& method : others_that_are_swept()) require_sweep(file, protocol, method);
}

}  // namespace piae::settings
