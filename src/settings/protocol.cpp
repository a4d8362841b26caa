#include "settings/protocol.hpp"

#include <spdlog/fmt/ranges.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "settings/groups.hpp"
#include "settings/lists.hpp"
#include "settings/method_options.hpp"
#include "settings/points.hpp"
#include "settings/sweeps.hpp"

namespace piae::settings {

namespace {

/// Stages that read settings. `train` may have a table for each method, `transfer` one for each
/// group of data sets.
const std::vector<std::string> stages = {"split",    "train",    "generate", "score",
                                         "diagnose", "tabulate", "sweep",    "identify",
                                         "readings", "transfer", "trust",    "teach"};

std::string nothing_reads(const std::string& path, const std::string& name,
                          const std::vector<std::string>& known) {
  std::string text = "nothing reads the table [" + path + name + "]";
  if (known.empty()) return text;
  return fmt::format("{}; known tables are {}{}", text, path, fmt::join(known, ", "));
}

/// Refuses tables in `parent` that are not among `known`. `path` is the beginning of their names.
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

/// Refuses a method's table that is `like` a missing table, or `like` one that is itself `like`
/// another.
void require_likeness(const std::filesystem::path& file, const toml::table& protocol,
                      const std::string& method, const toml::node& node) {
  try {
    (void)cli::options_of(protocol, "train", method);
  } catch (const Error& error) {
    refuse(file, node, error.what());
  }
}

/// Refuses settings that the training of a method refuses.
void require_method_options(const std::filesystem::path& file, const toml::table& table,
                            const std::string& method) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (node.is_table() || name == "like") continue;
    for (const std::string& value : cli::values_of(node)) {
      const std::string refusal = refusal_of(method, {.factor = name, .value = value});
      if (!refusal.empty()) {
        refuse(file, node,
               fmt::format("train.{}.{} is {}, which {}", method, name, value, refusal));
      }
    }
  }
}

/// Checks the tables of methods in [train], which must not contain tables.
void require_methods(const std::filesystem::path& file, const toml::table& protocol,
                     const toml::table& train) {
  for (const auto& [key, node] : train) {
    if (!node.is_table()) continue;
    const std::string method(key.str());
    require_known_tables(file, *node.as_table(), "train." + method + ".", {});
    require_likeness(file, protocol, method, node);
    require_method_options(file, *node.as_table(), method);
  }
}

/// Returns the methods that may have a table of their own in the table of a stage.
std::vector<std::string> methods_with_tables(const std::string& stage) {
  if (stage == "train") return augment::method_names();
  if (stage == "sweep") return others_that_are_swept();
  return {};
}

}  // namespace

toml::table read_protocol(const std::filesystem::path& file) {
  toml::table protocol = cli::parse_toml_file(file);
  for (const auto& [key, node] : protocol) {
    if (!node.is_table() && !node.is_array_of_tables()) {
      refuse(file, node, std::string(key.str()) + " is not in a table, so no stage reads it");
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
  require_sweeps(file, protocol);
  require_points(file, protocol, "readings", "base");
  require_points(file, protocol, "readings", "readings");
  return protocol;
}

std::vector<std::string> readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "readings");
}

std::vector<std::string> base_of_readings(const toml::table& protocol) {
  return words_of(protocol, "readings", "base");
}

}  // namespace piae::settings
