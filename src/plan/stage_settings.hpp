#pragma once

#include <map>
#include <memory>
#include <string>

#include "plan/experiment.hpp"
#include "plan/step.hpp"

namespace piae::plan {

/// Resolves what pipeline/ says of each stage. The settings of a stage go into small files of the
/// run, results/RUN/.settings, which the stage reads by --config: so what is compared is what is
/// used. A file holds values alone, in alphabetical order, so neither comments nor spacing count.
class StageSettings {
 public:
  /// `folder` is the run's folder.
  StageSettings(const Experiment& experiment, std::string folder);

  /// The settings of a stage, of its variant NAME where there is a table [STAGE.NAME].
  std::shared_ptr<const Settings> of(const std::string& stage, const std::string& variant = "");
  /// [split] of the description on top of that of the protocol.
  std::shared_ptr<const Settings> of_split(const Dataset& dataset);
  /// The description of a data set, completed by the one that it is like. Throws as
  /// signal::read_description_file() does.
  std::shared_ptr<const Settings> description(const Dataset& dataset);

 private:
  std::shared_ptr<const Settings> keep(const std::string& name, const std::string& source,
                                       const toml::table& values, const std::string& stage,
                                       const std::string& variant);

  const Experiment& experiment_;
  std::string folder_;
  std::map<std::string, std::shared_ptr<const Settings>> kept_;
};

/// The options of a stage that stages record, with what its program takes where nothing is set.
/// Empty for a stage that records none.
std::map<std::string, std::string> defaults_of_stage(const std::string& stage,
                                                     const std::string& variant);

}  // namespace piae::plan
