#include "plan/experiment.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "settings/protocol.hpp"
#include "signal/description_file.hpp"
#include "signal/split.hpp"

namespace piae::plan {

namespace fs = std::filesystem;
using augment::Needs;

namespace {

/// Returns the tables of a list of tables; an empty list if the key holds anything else.
std::vector<const toml::table*> tables_of(const toml::table& description, const char* key) {
  std::vector<const toml::table*> tables;
  if (const toml::array* list = description[key].as_array()) {
    for (const toml::node& node : *list) {
      if (node.is_table()) tables.push_back(node.as_table());
    }
  }
  return tables;
}

bool states_size(const toml::table& description, const toml::table& of_class) {
  if (of_class.contains("defect_size_mm")) return true;
  const auto name = of_class["name"].value<std::string>();
  return std::ranges::any_of(tables_of(description, "record"), [&](const toml::table* record) {
    return (*record)["class"].value<std::string>() == name && record->contains("defect_size_mm");
  });
}

std::vector<Needs> unsaid_in(const toml::table& description) {
  bool impact_rate = true;
  bool sizes = true;
  for (const toml::table* of_class : tables_of(description, "class")) {
    const auto defect = (*of_class)["defect"].value_or<std::string>("none");
    impact_rate = impact_rate && defect != "other";
    const bool has_size = defect != "none" && defect != "other";
    sizes = sizes && (!has_size || states_size(description, *of_class));
  }
  std::vector<Needs> unsaid;
  if (!impact_rate && !description.contains("bearing")) unsaid.push_back(Needs::bearing);
  if (!impact_rate) unsaid.push_back(Needs::impact_rate);
  if (!sizes) unsaid.push_back(Needs::size);
  return unsaid;
}

/// True if `split`, with the settings of the protocol and the description, makes known windows.
bool makes_known(const toml::table& protocol, const toml::table& description) {
  const auto own = description["split"][signal::known_per_class];
  const auto count = (own ? own : protocol["split"][signal::known_per_class]).value<std::int64_t>();
  return count != std::int64_t{0};
}

Dataset describe(const toml::table& protocol, const fs::path& file) {
  Dataset dataset{.name = file.stem().string()};
  try {
    const toml::table description = signal::read_description_file(file);
    dataset.is_simulated = description.contains("simulation");
    dataset.has_own_split = description.contains("split");
    dataset.any_known = makes_known(protocol, description);
    // A condition cannot be both known and tested.
    dataset.is_transfer = dataset.any_known && description["transfer"]["known"].is_array();
    dataset.unsaid = unsaid_in(description);
  } catch (const Error&) {
    return dataset;
  }
  return dataset;
}

std::vector<Dataset> read_datasets(const toml::table& protocol, const fs::path& folder) {
  std::vector<Dataset> datasets;
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, no_folder)) {
    if (entry.path().extension() == ".toml") datasets.push_back(describe(protocol, entry.path()));
  }
  std::ranges::sort(datasets, {}, &Dataset::name);
  return datasets;
}

}  // namespace

const Dataset* Experiment::find(const std::string& dataset) const {
  const auto found = std::ranges::find(datasets, dataset, &Dataset::name);
  return found == datasets.end() ? nullptr : &*found;
}

Experiment read_experiment(const fs::path& pipeline) {
  Experiment experiment;
  experiment.pipeline = pipeline;
  experiment.protocol = settings::read_protocol(pipeline / "protocol.toml");
  experiment.datasets = read_datasets(experiment.protocol, pipeline / "datasets");
  experiment.sweeps = settings::sweeps(experiment.protocol);
  experiment.readings = settings::readings(experiment.protocol);
  experiment.readings_base = settings::base_of_readings(experiment.protocol);
  experiment.groups = settings::groups(experiment.protocol);
  return experiment;
}

bool can_run(const augment::CatalogueEntry& method, const Dataset& dataset) {
  return std::ranges::none_of(dataset.unsaid, [&](Needs need) { return method.needs >= need; });
}

}  // namespace piae::plan
