#include "report/read_transfer.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "run/collect.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

std::vector<InputChoice> parse_inputs(const std::string& option,
                                      const std::vector<std::string>& words,
                                      const TransferOptions& options) {
  if (words.empty()) return {};
  const auto methods = run::split_list("--methods", options.methods);
  const auto classifiers = run::split_list("--classifiers", options.classifiers);
  std::vector<InputChoice> choices;
  for (const std::string& word : run::split_list(option, words)) {
    const InputChoice choice = parse_input_choice(word);
    if (std::ranges::count(choices, choice.method, &InputChoice::method) > 0) {
      throw Error(Exit::usage, option + ": names an input of " + choice.method + " twice");
    }
    const bool is_asked = std::ranges::count(methods, choice.method) > 0;
    if (is_asked && std::ranges::count(classifiers, choice.classifier) == 0) {
      throw Error(Exit::usage, "--classifiers: must have " + choice.classifier + ", which " +
                                   option + " names for " + choice.method);
    }
    choices.push_back(choice);
  }
  return choices;
}

/// A method that one question has an input for and the other has not would stand in half of the
/// tables.
void require_same_methods(const GroupChoices& choices) {
  const auto methods_of = [](const std::vector<InputChoice>& inputs) {
    std::set<std::string> methods;
    for (const InputChoice& input : inputs) methods.insert(input.method);
    return methods;
  };
  if (choices.kind_inputs.empty()) return;
  if (methods_of(choices.kind_inputs) == methods_of(choices.inputs)) return;
  throw Error(Exit::usage,
              "--kind-inputs: must name an input of each method that --inputs names "
              "one of, and of no other");
}

/// The names of all ratios that cells are read of: 100to1 for `none`, and the one asked for.
std::vector<std::string> ratios_with(const std::string& ratio) {
  if (scoring::find_ratio(ratio).generated_per_class == 0) {
    throw Error(Exit::usage, "--ratio " + ratio + ": generates nothing; name another");
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

/// The same results with the accuracies by kind of defect in the place of those by class. Empty
/// where kinds are not told apart.
std::optional<run::Results> by_kind(run::Results results) {
  for (run::Diagnosis& cell : results.diagnoses) {
    if (!cell.kind_accuracy) return std::nullopt;
    cell.accuracy = *cell.kind_accuracy;
  }
  return results;
}

DatasetRows dataset_rows(const run::Grid& grid, const run::Results& results) {
  DatasetRows rows{grid.dataset, accuracy_rows(grid, results, Published())};
  if (const auto kinds = by_kind(results)) rows.kinds = accuracy_rows(grid, *kinds, Published());
  return rows;
}

/// What all files lack is told at once, whichever dataset they are of.
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
                                     "; a mean over datasets needs the same of all");
  }
  return first;
}

}  // namespace

void bind(const cli::Options& command, TransferOptions& options) {
  command.add("--datasets", options.datasets, "Datasets of the group").required();
  command.add("--against", options.against, "Method that all others are subtracted from")
      .required();
  command
      .add("--inputs", options.inputs,
           "Which classifier each method is shown with, such as: none=wdcnn-spectrum; a method "
           "without one stands in the table by input alone")
      .required();
  command.add("--kind-inputs", options.kind_inputs,
              "The same for telling the kind of defect, whatever its size; without: as --inputs");
  command.add("--methods", options.methods, "Methods, such as: none smote").required();
  command
      .add("--ratio", options.ratio,
           "Ratio of the methods that generate windows, such as 1to1; none has 100to1")
      .required();
  command
      .add("--classifiers", options.classifiers,
           "Classifiers, such as: wdcnn wdcnn-spectrum; none also needs its cell of nearest")
      .required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

TransferGroup read_transfer(const std::filesystem::path& run, const TransferOptions& options) {
  const GroupChoices choices{
      .group = options.group,
      .against = options.against,
      .inputs = parse_inputs("--inputs", options.inputs, options),
      .kind_inputs = parse_inputs("--kind-inputs", options.kind_inputs, options)};
  require_same_methods(choices);
  run::GridOptions asked{.methods = run::split_list("--methods", options.methods),
                         .ratios = ratios_with(options.ratio),
                         .seeds = options.seeds,
                         .classifiers = options.classifiers};
  std::vector<run::Grid> grids;
  std::vector<run::Results> results;
  for (const std::string& dataset : run::split_list("--datasets", options.datasets)) {
    asked.dataset = dataset;
    grids.push_back(run::resolve(asked));
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
