#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "settings/groups.hpp"
#include "settings/sweeps.hpp"

namespace piae::plan {

/// A data set that has a description in pipeline/datasets/.
struct Dataset {
  std::string name;
  bool is_simulated = false;   ///< made by `simulate`, not read from recordings
  bool has_own_split = false;  ///< its description has a table [split]
  bool any_known = true;       ///< whether any fault window is known
  /// Facts about faults that its description lacks, by increasing need.
  std::vector<augment::Needs> unsaid = {};
};

/// The experiment as pipeline/ describes it: what there is to choose from.
struct Experiment {
  std::filesystem::path pipeline;  ///< folder with protocol.toml and datasets/
  toml::table protocol;
  std::vector<Dataset> datasets;  ///< by name
  std::vector<settings::Sweep> sweeps;
  std::vector<std::string> readings;       ///< "batches=class+space=class"
  std::vector<std::string> readings_base;  ///< "batches=all"
  std::vector<settings::Group> groups;

  /// Null where there is none of that name.
  [[nodiscard]] const Dataset* find(const std::string& dataset) const;
};

/// Reads protocol.toml and all descriptions. A description that cannot be read is refused when its
/// data set is used, not here. Throws as settings::read_protocol() does.
Experiment read_experiment(const std::filesystem::path& pipeline);

/// True if the description of a data set says what the method needs.
bool can_run(const augment::CatalogueEntry& method, const Dataset& dataset);

}  // namespace piae::plan
