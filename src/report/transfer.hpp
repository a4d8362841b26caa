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

/// Classifier that a method is shown with, chosen before on other seeds.
struct InputChoice {
  std::string method;
  std::string classifier;
};

/// Reads "none=wdcnn-spectrum". Throws Error(usage) for other formats, an unknown method or
/// classifier, and for two that do not go together (run/grid.hpp).
InputChoice parse_input_choice(const std::string& word);

/// Data set name of the mean over the data sets of a group.
inline const std::string mean_over_datasets = "mean";

/// Accuracies of one method by one classifier, on one data set or in the mean over several.
struct GroupCell {
  AccuracyRow row;
  /// The same by fault type; set if all its data sets have fault types.
  std::optional<AccuracyRow> type_accuracy;
};

/// Marks of a classifier in the row of its method.
struct Marks {
  bool recorded = false;  ///< chosen for the method before the run
  bool best = false;      ///< the best classifier in this run
};

/// Question about a window: its class, or its fault type whatever the size.
enum class Question { by_class, by_type };

/// One method by one classifier, on the data sets of a group.
struct GroupRow {
  std::string method;
  std::string classifier;
  std::vector<GroupCell> datasets;  ///< in the order of the group
  GroupCell mean;                   ///< for each seed the mean over the data sets
  Marks by_class = {};              ///< for classes
  Marks by_type = {};               ///< for fault types

  [[nodiscard]] const Marks& marks(Question question) const {
    return question == Question::by_class ? by_class : by_type;
  }
};

/// Returns the accuracies of a cell by class or by fault type. The cell must have them.
const AccuracyRow& answers(const GroupCell& cell, Question question);

/// Choices made before the run.
struct GroupChoices {
  std::string group;                     ///< "speeds"
  std::string against;                   ///< method that all others are subtracted from
  std::vector<InputChoice> inputs = {};  ///< at most one for each method
  /// The same for fault types; empty if the inputs for classes are used.
  std::vector<InputChoice> type_inputs = {};

  [[nodiscard]] const std::vector<InputChoice>& inputs_for(Question question) const;
  /// True for the rows of the main tables: a choice of either question, or a reference, which is
  /// `none` by a classifier without training: what is possible without generated windows and
  /// without a network.
  [[nodiscard]] bool shows(const std::string& method, const std::string& classifier) const;
  /// Returns the classifiers of these rows in the order of the catalogue, without rules.
  [[nodiscard]] std::vector<std::string> classifiers() const;
};

/// Accuracy of each method when faults are known in other conditions than they are tested in.
struct TransferGroup {
  GroupChoices choices;
  std::vector<std::string> datasets;
  signal::Protocol protocol = signal::Protocol::random;
  std::vector<std::int64_t> seeds;
  std::vector<GroupRow> rows;  ///< by method, then classifier, in the order of their catalogues
  /// own() minus each of others(), in the mean over the data sets. A row has the name of the
  /// subtracted method. Empty if own() is null.
  std::vector<PairedRow> differences = {};

  /// Returns the rows by the recorded inputs: one for each method that has such an input.
  [[nodiscard]] std::vector<const GroupRow*> recorded(Question question = Question::by_class) const;
  /// True if every row has accuracies by fault type.
  [[nodiscard]] bool has_fault_types() const;
  /// Returns the recorded row of `against`; null if there is none.
  [[nodiscard]] const GroupRow* own() const;
  /// Returns the recorded rows of all other methods, and references().
  [[nodiscard]] std::vector<const GroupRow*> others() const;
  /// Returns the references (GroupChoices::shows()) that are not recorded.
  [[nodiscard]] std::vector<const GroupRow*> references(
      Question question = Question::by_class) const;
  [[nodiscard]] static bool is_reference(const GroupRow& row,
                                         Question question = Question::by_class);
  /// Returns the row by the best classifier of a method in this run; null without a row.
  [[nodiscard]] const GroupRow* best_of(const std::string& method,
                                        Question question = Question::by_class) const;
};

/// Returns for each seed the mean over the rows, which belong to one method and classifier but
/// different data sets. Throws Error(bad_input) if their seeds differ, because the means of
/// different seeds would then cover different data sets.
AccuracyRow mean_of_datasets(const std::vector<AccuracyRow>& rows);

/// All rows of a data set at one ratio, and at 100to1 for `none`.
struct DatasetRows {
  std::string dataset;
  std::vector<AccuracyRow> rows;
  /// The same by fault type; empty if the data set does not have fault types.
  std::vector<AccuracyRow> types = {};
};

/// Combines data sets that have the same methods and classifiers. Throws as mean_of_datasets()
/// does.
TransferGroup transfer_group(GroupChoices choices, const std::vector<DatasetRows>& datasets);

/// A group of data sets, as in [transfer.GROUP] of pipeline/protocol.toml, and the cells of its
/// table.
struct TransferOptions {
  std::string group = {};
  std::vector<std::string> datasets = {};
  std::string against = {};
  std::vector<std::string> inputs = {};       ///< "none=wdcnn-spectrum", see parse_input_choice()
  std::vector<std::string> type_inputs = {};  ///< the same for fault types; may be empty
  std::vector<std::string> methods = {};
  std::string ratio = {};                     ///< of the generated windows; `none` uses 100to1
  std::vector<std::string> classifiers = {};  ///< default: each method by its inputs alone
  std::vector<std::string> seeds = {};
};

/// Binds all options but --group, which a program needs before the others
/// (cli::Stage::choose_variant).
void bind(const cli::Options& command, TransferOptions& options);

/// Reads the cells from the folder of a run, such as results/paper. Throws Error(usage) as
/// run::resolve() and parse_input_choice() do, for a method with two inputs, and for a ratio that
/// generates nothing. Throws Error as
/// run::require_all() for missing or refused cells, and Error(bad_input) if the data sets were
/// split by different protocols.
TransferGroup read_transfer(const std::filesystem::path& run, const TransferOptions& options);

}  // namespace piae::report
