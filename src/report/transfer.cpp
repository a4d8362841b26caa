#include "report/transfer.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/gaps.hpp"
#include "run/collect.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

const AccuracyRow* find_by(const std::vector<AccuracyRow>& rows, const std::string& method,
                           const std::string& classifier) {
  const auto found = std::ranges::find_if(rows, [&](const AccuracyRow& row) {
    return row.method == method && row.classifier == classifier;
  });
  return found == rows.end() ? nullptr : &*found;
}

GroupCell cell_of_means(const std::vector<GroupCell>& cells) {
  std::vector<AccuracyRow> rows;
  std::vector<AccuracyRow> types;
  for (const GroupCell& cell : cells) {
    rows.push_back(cell.row);
    if (cell.type_accuracy) types.push_back(*cell.type_accuracy);
  }
  GroupCell mean{mean_of_datasets(rows), std::nullopt};
  if (types.size() == rows.size()) mean.type_accuracy = mean_of_datasets(types);
  return mean;
}

/// Returns nothing if a data set does not have the method by this classifier.
std::optional<GroupRow> group_row(const std::vector<DatasetRows>& datasets,
                                  const std::string& method, const std::string& classifier) {
  GroupRow group{.method = method, .classifier = classifier, .datasets = {}, .mean = {}};
  for (const DatasetRows& each : datasets) {
    const AccuracyRow* const row = find_by(each.rows, method, classifier);
    if (row == nullptr) return std::nullopt;
    GroupCell& cell = group.datasets.emplace_back(GroupCell{*row, std::nullopt});
    if (const AccuracyRow* const type_accuracy = find_by(each.types, method, classifier))
      cell.type_accuracy = *type_accuracy;
  }
  group.mean = cell_of_means(group.datasets);
  return group;
}

bool is_among(const std::vector<InputChoice>& choices, const GroupRow& row) {
  return std::ranges::any_of(choices, [&](const InputChoice& choice) {
    return choice.method == row.method && choice.classifier == row.classifier;
  });
}

/// Returns the best row of a method; of equal ones the first.
GroupRow* best_row(std::vector<GroupRow>& rows, const std::string& method, Question question) {
  const auto mean = [&](const GroupRow& row) { return answers(row.mean, question).summary.mean; };
  GroupRow* best = nullptr;
  for (GroupRow& row : rows) {
    if (row.method != method) continue;
    if (best == nullptr || mean(row) > mean(*best)) best = &row;
  }
  return best;
}

bool needs_nothing(const std::string& method, const std::string& classifier) {
  return method == augment::no_method && !diagnosis::the_classifier(classifier).trains();
}

void mark(TransferGroup& group) {
  for (GroupRow& row : group.rows) {
    row.by_class.recorded = is_among(group.choices.inputs_for(Question::by_class), row);
    row.by_type.recorded = is_among(group.choices.inputs_for(Question::by_type), row);
  }
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    GroupRow* const best = best_row(group.rows, entry.name, Question::by_class);
    if (best == nullptr) continue;
    best->by_class.best = true;
    if (!group.has_fault_types()) continue;
    best_row(group.rows, entry.name, Question::by_type)->by_type.best = true;
  }
}

std::vector<PairedRow> differences_of(const TransferGroup& group) {
  std::vector<PairedRow> differences;
  if (group.own() == nullptr) return differences;
  for (const GroupRow* const other : group.others()) {
    auto pair = paired_row(group.own()->mean.row, other->mean.row);
    pair.value().method =
        TransferGroup::is_reference(*other) ? reference_label(other->mean.row) : other->method;
    differences.push_back(std::move(*pair));
  }
  add_holm_p(differences);
  return differences;
}

std::vector<InputChoice> parse_inputs(const std::string& option,
                                      const std::vector<std::string>& words) {
  if (words.empty()) return {};
  std::vector<InputChoice> choices;
  for (const std::string& word : run::split_list(option, words)) {
    const InputChoice choice = parse_input_choice(word);
    if (std::ranges::count(choices, choice.method, &InputChoice::method) > 0) {
      throw Error(Exit::usage, option + ": names an input of " + choice.method + " twice");
    }
    choices.push_back(choice);
  }
  return choices;
}

/// Refuses a method that has an input for one question only, because it would be in half of the
/// tables.
void require_same_methods(const GroupChoices& choices) {
  const auto methods_of = [](const std::vector<InputChoice>& inputs) {
    std::set<std::string> methods;
    for (const InputChoice& input : inputs) methods.insert(input.method);
    return methods;
  };
  if (choices.type_inputs.empty()) return;
  if (methods_of(choices.type_inputs) == methods_of(choices.inputs)) return;
  throw Error(Exit::usage,
              "--kind-inputs: must name one input for each method of --inputs, and for no other");
}

/// Returns the names of the ratios to read: the requested one, and 100to1 for `none`.
std::vector<std::string> ratios_with(const std::string& ratio) {
  if (scoring::find_ratio(ratio).generated_per_class == 0) {
    throw Error(Exit::usage, "--ratio " + ratio + ": no window is generated there; choose another");
  }
  std::vector<std::string> names{ratio};
  for (const scoring::Ratio& each : scoring::all_ratios()) {
    if (each.generated_per_class == 0) names.emplace_back(each.name);
  }
  return names;
}

run::Results collect_diagnoses(const run::Layout& layout, const run::Grid& grid) {
  run::Results results;
  run::collect_diagnoses(layout, grid.dataset, run::series_of(grid), results);
  return results;
}

/// Returns the results with accuracies by fault type instead of by class. Empty if the data set
/// does not have fault types.
std::optional<run::Results> by_type(run::Results results) {
  for (run::Diagnosis& cell : results.diagnoses) {
    if (!cell.type_accuracy) return std::nullopt;
    cell.accuracy = *cell.type_accuracy;
  }
  return results;
}

DatasetRows dataset_rows(const run::Grid& grid, const run::Results& results) {
  DatasetRows rows{grid.dataset, accuracy_rows(grid, results, Published())};
  if (const auto types = by_type(results)) rows.types = accuracy_rows(grid, *types, Published());
  return rows;
}

/// Reports the problems of all data sets in one error.
void require_all_of(const std::vector<run::Results>& datasets) {
  run::Results all;
  for (const run::Results& each : datasets) {
    std::ranges::copy(each.problems, std::back_inserter(all.problems));
    if (all.exit != Exit::bad_input && each.exit != Exit::done) all.exit = each.exit;
  }
  run::require_all(all);
}

signal::Protocol protocol_of(const std::vector<run::Grid>& grids,
                             const std::vector<run::Results>& results) {
  const signal::Protocol first = results.front().diagnoses.front().protocol;
  for (std::size_t i = 1; i < results.size(); ++i) {
    const signal::Protocol own = results[i].diagnoses.front().protocol;
    if (own == first) continue;
    throw Error(Exit::bad_input, grids[i].dataset + ": the split is " + to_string(own) + ", and " +
                                     to_string(first) + " of " + grids.front().dataset +
                                     "; a mean over data sets needs the same for all");
  }
  return first;
}

}  // namespace

InputChoice parse_input_choice(const std::string& word) {
  const std::size_t equals = word.find('=');
  const auto refuse = [&](const std::string& why) {
    throw Error(Exit::usage, "'" + word + "' " + why);
  };
  if (equals == std::string::npos) {
    refuse("is not METHOD=CLASSIFIER; write one such as none=wdcnn-spectrum");
  }
  InputChoice choice{word.substr(0, equals), word.substr(equals + 1)};
  if (augment::find_entry(choice.method) == nullptr) refuse("names an unknown method");
  const diagnosis::Classifier* const classifier = diagnosis::find_classifier(choice.classifier);
  if (classifier == nullptr) refuse("names an unknown classifier");
  if (!run::go_together(choice.method, choice.classifier, false)) {
    refuse("does not go together: rules run with none only");
  }
  return choice;
}

const std::vector<InputChoice>& GroupChoices::inputs_for(Question question) const {
  return question == Question::by_type && !type_inputs.empty() ? type_inputs : inputs;
}

bool GroupChoices::shows(const std::string& method, const std::string& classifier) const {
  const auto is_the_choice = [&](const InputChoice& choice) {
    return choice.method == method && choice.classifier == classifier;
  };
  return needs_nothing(method, classifier) || std::ranges::any_of(inputs, is_the_choice) ||
         std::ranges::any_of(type_inputs, is_the_choice);
}

std::vector<std::string> GroupChoices::classifiers() const {
  std::vector<std::string> names;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    const auto has_it = [&](const std::vector<InputChoice>& choices) {
      return std::ranges::count(choices, each.name, &InputChoice::classifier) > 0;
    };
    const bool refers = !each.trains() && !each.rule;
    if (refers || has_it(inputs) || has_it(type_inputs)) names.emplace_back(each.name);
  }
  return names;
}

const AccuracyRow& answers(const GroupCell& cell, Question question) {
  return question == Question::by_class ? cell.row : cell.type_accuracy.value();
}

std::vector<const GroupRow*> TransferGroup::recorded(Question question) const {
  std::vector<const GroupRow*> own;
  for (const GroupRow& row : rows) {
    if (row.marks(question).recorded) own.push_back(&row);
  }
  return own;
}

bool TransferGroup::has_fault_types() const {
  return std::ranges::all_of(
      rows, [](const GroupRow& row) { return row.mean.type_accuracy.has_value(); });
}

const GroupRow* TransferGroup::own() const {
  const auto all = recorded();
  const auto found = std::ranges::find(all, choices.against, &GroupRow::method);
  return found == all.end() ? nullptr : *found;
}

std::vector<const GroupRow*> TransferGroup::others() const {
  std::vector<const GroupRow*> others = recorded();
  std::erase(others, own());
  std::ranges::copy(references(), std::back_inserter(others));
  return others;
}

std::vector<const GroupRow*> TransferGroup::references(Question question) const {
  std::vector<const GroupRow*> references;
  for (const GroupRow& row : rows) {
    if (is_reference(row, question)) references.push_back(&row);
  }
  return references;
}

bool TransferGroup::is_reference(const GroupRow& row, Question question) {
  return !row.marks(question).recorded && needs_nothing(row.method, row.classifier);
}

const GroupRow* TransferGroup::best_of(const std::string& method, Question question) const {
  const auto found = std::ranges::find_if(
      rows, [&](const GroupRow& row) { return row.method == method && row.marks(question).best; });
  return found == rows.end() ? nullptr : &*found;
}

AccuracyRow mean_of_datasets(const std::vector<AccuracyRow>& rows) {
  AccuracyRow mean = rows.front();
  mean.dataset = mean_over_datasets;
  mean.type_accuracy.reset();
  mean.speed_ratio.reset();
  std::ranges::fill(mean.values, 0);
  for (const AccuracyRow& row : rows) {
    if (row.seeds != mean.seeds) {
      throw Error(Exit::bad_input, run::name_by(row.method, row.classifier) + ": " + row.dataset +
                                       " has the seeds " + seed_list(row.seeds) + ", but " +
                                       rows.front().dataset + " has " + seed_list(mean.seeds) +
                                       "; a mean over data sets needs the same for all");
    }
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      mean.values[i] += row.values[i] / static_cast<double>(rows.size());
    }
  }
  mean.summary = summarise_within(percents, mean.values);
  return mean;
}

TransferGroup transfer_group(GroupChoices choices, const std::vector<DatasetRows>& datasets) {
  TransferGroup group{.choices = std::move(choices), .datasets = {}, .seeds = {}, .rows = {}};
  for (const DatasetRows& each : datasets) group.datasets.push_back(each.dataset);
  group.seeds = datasets.front().rows.front().seeds;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
      auto row = group_row(datasets, entry.name, classifier.name);
      if (!row) continue;
      group.rows.push_back(std::move(*row));
    }
  }
  mark(group);
  group.differences = differences_of(group);
  return group;
}

void bind(const cli::Options& command, TransferOptions& options) {
  command.add("--datasets", options.datasets, "Data sets of the group").required();
  command
      .add("--against", options.against, "Reference method, from which all others are subtracted")
      .required();
  command
      .add("--inputs", options.inputs,
           "Classifier of each method, such as: none=wdcnn-spectrum; a method without one appears "
           "only in the table by classifier")
      .required();
  command.add("--kind-inputs", options.type_inputs,
              "The same for the fault type, whatever its size; default: --inputs");
  command.add("--methods", options.methods, "Methods, such as: none smote").required();
  command
      .add("--ratio", options.ratio,
           "Ratio of the methods that generate windows, such as 1to1; none has 100to1")
      .required();
  run::bind_classifiers(
      command, options.classifiers,
      "none also needs its cell by nearest; default: each method by its --inputs");
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

TransferGroup read_transfer(const std::filesystem::path& run, const TransferOptions& options) {
  const GroupChoices choices{.group = options.group,
                             .against = options.against,
                             .inputs = parse_inputs("--inputs", options.inputs),
                             .type_inputs = parse_inputs("--kind-inputs", options.type_inputs)};
  require_same_methods(choices);
  run::GridOptions requested{.methods = run::split_list("--methods", options.methods),
                             .ratios = ratios_with(options.ratio),
                             .seeds = options.seeds,
                             .classifiers = options.classifiers};
  const bool only_shown = options.classifiers.empty();
  if (only_shown) requested.classifiers = choices.classifiers();
  std::vector<run::Grid> grids;
  std::vector<run::Results> results;
  for (const std::string& dataset : run::split_list("--datasets", options.datasets)) {
    requested.dataset = dataset;
    grids.push_back(run::resolve(requested));
    std::erase_if(grids.back().combinations, [&](const run::Combination& cell) {
      return only_shown && !choices.shows(cell.method, cell.classifier);
    });
    results.push_back(collect_diagnoses(run::Layout(run, dataset), grids.back()));
  }
  require_all_of(results);
  std::vector<DatasetRows> rows;
  for (std::size_t i = 0; i < grids.size(); ++i) rows.push_back(dataset_rows(grids[i], results[i]));
  TransferGroup group = transfer_group(choices, rows);
  group.protocol = protocol_of(grids, results);
  return group;
}

}  // namespace piae::report
