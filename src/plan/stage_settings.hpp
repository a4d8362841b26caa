#pragma once

#include <map>
#include <memory>
#include <string>

#include "plan/experiment.hpp"
#include "plan/step.hpp"

namespace piae::plan {

/// Resolves each stage's settings from pipeline/protocol.toml and the descriptions. They are
/// written below results/RUN/.settings (settings_files.hpp), where the stage reads them by
/// --config, so the plan compares exactly what a stage uses. A file holds values only, in
/// alphabetical order, so comments and spacing do not count.
class StageSettings {
 public:
  /// `folder` is the folder of the run.
  StageSettings(const Experiment& experiment, std::string folder);

  /// Returns the settings of a stage, with those of [STAGE.NAME] for the variant NAME if that table
  /// exists.
  std::shared_ptr<const Settings> of(const std::string& stage, const std::string& variant = "");
  /// Returns the settings of [split]: those of the protocol, overridden by the description's.
  std::shared_ptr<const Settings> of_split(const Dataset& dataset);
  /// Returns the description of a data set, completed from the description that it is `like`.
  /// Throws as signal::read_description_file() does.
  std::shared_ptr<const Settings> description(const Dataset& dataset);

 private:
  std::shared_ptr<const Settings> keep(const std::string& name, const std::string& source,
                                       const toml::table& values, const std::string& stage,
                                       const std::string& variant);

  const Experiment& experiment_;
  std::string folder_;
  std::map<std::string, std::shared_ptr<const Settings>> kept_;
};

/// Returns the recorded options of a stage with the defaults of its program. Empty for a stage that
/// records no options.
std::map<std::string, std::string> defaults_of_stage(const std::string& stage,
                                                     const std::string& variant);

}  // namespace piae::plan
