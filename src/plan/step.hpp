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

/// The options of a stage that stand in pipeline/, and the file by which a step reads them.
struct Settings {
  std::string file = {};  ///< results/RUN/.settings/train.smote.toml
  std::string text = {};  ///< what it is to hold
  /// Options without dashes, with their values as text: "learning-rate", "5e-4".
  std::map<std::string, std::string> values = {};
  std::map<std::string, std::string> defaults =
      {};                                    ///< what the program takes where nothing is set
  std::vector<std::string> recordings = {};  ///< raw files, and patterns, that a description names
};

/// An input of a step.
struct Input {
  std::string role;                ///< the option that names it, "known"; else what it is, "cells"
  std::vector<std::string> files;  ///< one, unless `is_option` is false
  bool is_option = true;           ///< whether the command names the file, as --ROLE FILE
  /// The digest that the file will have, where it is written before the step runs.
  std::optional<std::string> digest = std::nullopt;
  /// Programs of before did not record this input: then it counts as unchanged.
  bool may_be_unrecorded = false;
  /// A file that is not there has not changed: recordings need not be kept.
  bool may_be_absent = false;
};

/// The place of a step in the grid, by which its cost is known. What does not apply is empty.
struct Place {
  std::string dataset = {};
  std::optional<std::int64_t> seed = {};
  std::string unit = {};  ///< folder below that of the seed: "smote", "sweep/batch-1"
  std::string method = {};
  std::string ratio = {};
  std::string classifier = {};
};

using StepId = std::size_t;

/// One call of a stage.
struct Step {
  std::string stage = {};   ///< "train"
  std::string folder = {};  ///< where its log lies: results/RUN/DATASET/...
  std::string log =
      {};  ///< name of the log, "train"; another than the stage's where a folder has two
  std::shared_ptr<const Settings> settings = {};     ///< null where the stage reads none
  std::shared_ptr<const Settings> description = {};  ///< of a data set, where the stage reads one
  std::vector<Input> inputs = {};
  /// Options of the command that count as settings, without dashes: "seed", "3". A value of several
  /// words is several values.
  std::vector<std::pair<std::string, std::string>> options = {};
  /// Further words of the command, which change nothing of what is made.
  std::vector<std::string> words = {};
  std::vector<std::string> outputs = {};
  std::string output_option = {};  ///< "output" where the command names the first output
  Place place = {};
  bool is_asked = true;     ///< whether it is to be made if it is due
  bool is_held = false;     ///< it stands here only for what the run holds, and is never made
  bool is_artefact = true;  ///< its outputs say themselves how they were made
  /// The folder of which it makes all CSV files, where nobody knows their names before it has run.
  std::string tables_folder = {};
  bool is_always_due = false;  ///< it shows how the run is at the time
};

/// The path of the log of a step.
inline std::string log_of(const Step& step) { return step.folder + '/' + step.log + ".log"; }

/// The steps of a run, each behind all that it waits for.
class Graph {
 public:
  StepId add(Step step);

  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] Step& at(StepId id) { return steps_.at(id); }
  [[nodiscard]] const Step& at(StepId id) const { return steps_.at(id); }
  /// The step that makes a file.
  [[nodiscard]] std::optional<StepId> maker_of(const std::string& file) const;
  /// The steps that this one waits for, each once, ascending.
  [[nodiscard]] const std::vector<StepId>& needs(StepId id) const { return needs_.at(id); }

 private:
  std::vector<Step> steps_;
  std::vector<std::vector<StepId>> needs_;
  std::unordered_map<std::string, StepId> makers_;
};

/// The words of the command: stage, options, and behind `--` the files that it makes, where no
/// option names them.
std::vector<std::string> command_of(const Step& step);

}  // namespace piae::plan
