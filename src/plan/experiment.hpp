#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "settings/groups.hpp"
#include "settings/sweeps.hpp"

namespace piae::plan {

/// A data set with a description in pipeline/datasets/.
struct Dataset {
  std::string name;
  bool is_simulated = false;   ///< made by `simulate`, not from recordings
  bool has_own_split = false;  ///< its description has a table [split]
  bool any_known = true;       ///< true if any fault window is known
  bool is_transfer = false;    ///< faults are known in other conditions than the tested ones
  /// Facts about faults that the description lacks, by increasing need.
  std::vector<augment::Needs> unsaid = {};
};

/// The experiment that pipeline/ describes: everything that can be requested.
struct Experiment {
  std::filesystem::path pipeline;  ///< folder with protocol.toml and datasets/
  toml::table protocol;
  std::vector<Dataset> datasets;  ///< by name
  std::vector<settings::Sweep> sweeps;
  std::vector<std::string> readings;       ///< "batches=class+space=class"
  std::vector<std::string> readings_base;  ///< "batches=all"
  std::vector<settings::Group> groups;

  /// Returns null if no data set has this name.
  [[nodiscard]] const Dataset* find(const std::string& dataset) const;
};

/// Reads protocol.toml and all descriptions. An unreadable description is refused later, when its
/// data set is used. Throws as settings::read_protocol() does.
Experiment read_experiment(const std::filesystem::path& pipeline);

/// True if the description of a data set contains what the method needs.
bool can_run(const augment::CatalogueEntry& method, const Dataset& dataset);

}  // namespace piae::plan
