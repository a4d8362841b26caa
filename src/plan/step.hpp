#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace piae::plan {

/// Options of a stage from pipeline/, and the file from which a step reads them.
struct Settings {
  std::string file = {};  ///< results/RUN/.settings/train.smote.toml
  std::string text = {};  ///< contents that the file should have
  /// Options without dashes and their values as text: "learning-rate", "5e-4".
  std::map<std::string, std::string> values = {};
  std::map<std::string, std::string> defaults = {};  ///< the program's defaults
  std::vector<std::string> recordings = {};  ///< raw files and patterns that a description names
};

/// An input of a step.
struct Input {
  std::string role;                ///< option that names it, "known"; else its contents, "cells"
  std::vector<std::string> files;  ///< one file if `is_option`
  bool is_option = true;           ///< true if the command names the file, as --ROLE FILE
  /// Digest that the file will have, if it is written before the step runs.
  std::optional<std::string> digest = std::nullopt;
  /// Older programs did not record this input: then it counts as unchanged.
  bool may_be_unrecorded = false;
  /// A missing file counts as unchanged: recordings may be deleted.
  bool may_be_absent = false;
};

/// Place of a step in the grid, the key of its cost. Fields that do not apply are empty.
struct Place {
  std::string dataset = {};
  std::optional<std::int64_t> seed = {};
  std::string unit = {};  ///< below the seed's folder: "smote", "sweep/batch-1"
  std::string method = {};
  std::string ratio = {};
  std::string classifier = {};
};

using StepId = std::size_t;

/// One call of a stage.
struct Step {
  std::string stage = {};   ///< "train"
  std::string folder = {};  ///< of its log: results/RUN/DATASET/...
  std::string log =
      {};  ///< name of the log, "train"; differs from the stage if a folder has two such steps
  std::shared_ptr<const Settings> settings = {};  ///< null if the stage reads none
  std::shared_ptr<const Settings> description =
      {};  ///< description of a data set; null if the stage reads none
  std::vector<Input> inputs = {};
  /// Options of the command that count as settings, without dashes: "seed", "3". Several words
  /// stand for several values.
  std::vector<std::pair<std::string, std::string>> options = {};
  /// Further words of the command, without effect on the outputs.
  std::vector<std::string> words = {};
  std::vector<std::string> outputs = {};
  std::string output_option = {};  ///< "output" if an option names the first output
  Place place = {};
  bool is_requested = true;  ///< true if it is made when it is due
  bool is_held = false;      ///< true if it represents files that the run holds; never made
  bool is_artefact = true;   ///< true if the outputs record how they were made
  /// Folder whose CSV files are all outputs, because their names are unknown before the run.
  std::string tables_folder = {};
  bool is_always_due = false;  ///< true if it shows the present state of the run
};

/// Returns the name of a step, which the journal and `make why` use.
inline std::string name_of(const Step& step) { return step.folder + '/' + step.log; }

/// Returns the path of the log of a step.
inline std::string log_of(const Step& step) { return name_of(step) + ".log"; }

/// The steps of a run, each after all steps that it needs.
class Graph {
 public:
  /// Returns the existing step if two goals add the same one. Throws std::logic_error if a step
  /// with other outputs has the same name.
  StepId add(Step step);

  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] Step& at(StepId id) { return steps_.at(id); }
  [[nodiscard]] const Step& at(StepId id) const { return steps_.at(id); }
  /// Returns the step that makes a file.
  [[nodiscard]] std::optional<StepId> maker_of(const std::string& file) const;
  /// Returns the step of this name.
  [[nodiscard]] std::optional<StepId> step_named(const std::string& name) const;
  /// Returns the steps that this one needs, each once, ascending.
  [[nodiscard]] const std::vector<StepId>& needs(StepId id) const { return needs_.at(id); }

 private:
  std::vector<Step> steps_;
  std::vector<std::vector<StepId>> needs_;
  std::unordered_map<std::string, StepId> makers_;  ///< by file
  std::unordered_map<std::string, StepId> named_;
};

/// Returns the words of the command: the stage, the options, and after `--` the outputs that no
/// option names.
std::vector<std::string> command_of(const Step& step);

}  // namespace piae::plan
