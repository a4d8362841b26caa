#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "report/accuracies.hpp"
#include "report/paired_rows.hpp"
#include "signal/protocol.hpp"

namespace piae::report {

/// Which classifier a method is shown with: a choice that was made before, on other seeds.
struct InputChoice {
  std::string method;
  std::string classifier;
};

/// Reads "none=wdcnn-spectrum". Throws Error(usage) for what is not METHOD=CLASSIFIER, for a method
/// or a classifier that there is not, and for a classifier that does not train: it has no input to
/// choose, and stands beside all methods anyway.
InputChoice parse_input_choice(const std::string& word);

/// Stands in the place of a dataset's name for the mean over those of a group.
inline const std::string mean_over_datasets = "mean";

/// The accuracies of one method by one classifier, on one dataset or in the mean over several.
struct GroupCell {
  AccuracyRow row;
  /// The same by kind of defect; there where every dataset that it is of tells kinds apart.
  std::optional<AccuracyRow> kind;
};

/// What an input is to its method.
struct Marks {
  bool recorded = false;  ///< the one that was chosen for the method before the run
  bool best = false;      ///< the best of those of a trained classifier in this very run
};

/// What is asked of a window: its class, or its kind of defect, whatever the size.
enum class Question { by_class, by_kind };

/// One method by one classifier, on the datasets of a group.
struct GroupRow {
  std::string method;
  std::string classifier;
  std::vector<GroupCell> datasets;  ///< in the order of the group
  GroupCell mean;                   ///< for each seed the mean over the datasets
  Marks by_class = {};              ///< as an input for telling classes
  Marks by_kind = {};               ///< as an input for telling kinds of defect

  [[nodiscard]] const Marks& marks(Question question) const {
    return question == Question::by_class ? by_class : by_kind;
  }
};

/// The accuracies of a cell by class or by kind, which it must tell.
const AccuracyRow& answers(const GroupCell& cell, Question question);

/// What was chosen before the run.
struct GroupChoices {
  std::string group;                     ///< "speeds"
  std::string against;                   ///< the method that all others are subtracted from
  std::vector<InputChoice> inputs = {};  ///< at most one for each method
  /// The same for telling kinds of defect; empty where those of classes are taken.
  std::vector<InputChoice> kind_inputs = {};

  [[nodiscard]] const std::vector<InputChoice>& inputs_for(Question question) const;
};

/// What each method is worth where faults are known in other conditions than they are tested in.
struct TransferGroup {
  GroupChoices choices;
  std::vector<std::string> datasets;
  signal::Protocol protocol = signal::Protocol::random;
  std::vector<std::int64_t> seeds;
  std::vector<GroupRow> rows;  ///< by method, then classifier, in the order of their catalogues
  /// own() minus each of others(), in the mean over the datasets. A row has the name of what is
  /// subtracted. Empty where there is no own().
  std::vector<PairedRow> differences = {};

  /// The rows by the inputs that are recorded: one for each method that has one.
  [[nodiscard]] std::vector<const GroupRow*> recorded(Question question = Question::by_class) const;
  /// Whether every row tells kinds of defect.
  [[nodiscard]] bool tells_kinds() const;
  /// That of `against`; null where it has none.
  [[nodiscard]] const GroupRow* own() const;
  /// Those of all other methods, and the bar.
  [[nodiscard]] std::vector<const GroupRow*> others() const;
  /// None by the bar's classifier; null where it is not there.
  [[nodiscard]] const GroupRow* bar() const;
  /// The best input of a method in this run; null where it has none of a trained classifier.
  [[nodiscard]] const GroupRow* best_of(const std::string& method,
                                        Question question = Question::by_class) const;
};

/// For each seed the mean over the rows, which are of one method and one classifier, each of
/// another dataset. Throws Error(bad_input) where they do not have the same seeds: their mean would
/// be of other datasets from seed to seed.
AccuracyRow mean_of_datasets(const std::vector<AccuracyRow>& rows);

/// All rows of a dataset at one ratio, and at 100to1 for `none`.
struct DatasetRows {
  std::string dataset;
  std::vector<AccuracyRow> rows;
  /// The same by kind of defect; empty where it does not tell kinds apart.
  std::vector<AccuracyRow> kinds = {};
};

/// Puts datasets together that have the same methods and classifiers. Throws as
/// mean_of_datasets() does.
TransferGroup transfer_group(GroupChoices choices, const std::vector<DatasetRows>& datasets);

/// A group of datasets, as [transfer.GROUP] of pipeline/protocol.toml describes it, and the cells
/// that a table of it is made of.
struct TransferOptions {
  std::string group = {};
  std::vector<std::string> datasets = {};
  std::string against = {};
  std::vector<std::string> inputs = {};       ///< "none=wdcnn-spectrum", see parse_input_choice()
  std::vector<std::string> kind_inputs = {};  ///< the same for telling kinds; may be empty
  std::vector<std::string> methods = {};
  std::string ratio = {};  ///< of the generated windows; `none` is taken at 100to1
  std::vector<std::string> classifiers = {};
  std::vector<std::string> seeds = {};
};

/// Binds all but --group, which a program needs before the others (cli::Stage::choose_variant).
void bind(const cli::Options& command, TransferOptions& options);

/// Reads the cells from the folder of a run, such as results/paper. Throws Error(usage) as
/// run::resolve() and parse_input_choice() do, for a method with two inputs, for a ratio at which
/// nothing is generated, and where the input that is recorded for a method is not among the
/// classifiers; Error as run::require_all() for cells that are missing or refused; and
/// Error(bad_input) for datasets that were split by different protocols.
TransferGroup read_transfer(const std::filesystem::path& run, const TransferOptions& options);

}  // namespace piae::report
