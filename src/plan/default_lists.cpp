#include "plan/default_lists.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/symptom_net.hpp"
#include "plan/words.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::plan {

namespace {

bool is_the_papers(const augment::CatalogueEntry& method) {
  using augment::Kind;
  return method.kind == Kind::baseline || method.kind == Kind::published ||
         method.kind == Kind::ablation;
}

Words default_methods() {
  Words methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_the_papers(entry) || entry.recommended) methods.emplace_back(entry.name);
  }
  return methods;
}

Words names_of_ratios() {
  Words names;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) names.emplace_back(ratio.name);
  return names;
}

/// Returns the classifiers of verdicts: the rules, the nearest neighbour and symptom-net.
Words classifiers_of_verdicts() {
  Words names;
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    const std::string name = classifier.name;
    if (classifier.rule || name == diagnosis::reference_classifier ||
        name == diagnosis::symptom_net.name) {
      names.push_back(name);
    }
  }
  return names;
}

/// Returns what judges records against a healthy one: all that works without known fault windows,
/// except ceilings.
Lists lists_of_verdicts() {
  Lists lists{.datasets = {"cwru-blind"},
              .methods = {augment::no_method},
              .ratios = {scoring::all_ratios().front().name, scoring::all_ratios().back().name},
              .classifiers = classifiers_of_verdicts(),
              .seeds = {0}};
  for (const std::string& method : augment::methods_without_known()) {
    if (!augment::is_ceiling(method)) lists.methods.push_back(method);
  }
  return lists;
}

/// Returns these groups' data sets, and their methods with all classifiers that a group shows, at
/// the ratio with the most generated windows.
Lists lists_of(const std::vector<settings::Group>& groups, const Experiment& experiment) {
  Lists lists;
  std::set<std::string> methods;
  std::set<std::string> datasets;
  std::set<std::string> classifiers;
  for (const settings::Group& group : groups) {
    datasets.insert(group.datasets.begin(), group.datasets.end());
    for (const report::InputChoice& input : group.choices.inputs) methods.insert(input.method);
    for (const std::string& name : group.choices.classifiers()) classifiers.insert(name);
  }
  for (const Dataset& dataset : experiment.datasets) {
    if (datasets.contains(dataset.name)) lists.datasets.push_back(dataset.name);
  }
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (methods.contains(entry.name)) lists.methods.emplace_back(entry.name);
  }
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    if (ratio.generated_per_class == 0) lists.ratios.emplace_back(ratio.name);
  }
  lists.ratios.emplace_back(scoring::all_ratios().back().name);
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    if (classifiers.contains(classifier.name)) lists.classifiers.emplace_back(classifier.name);
  }
  return lists;
}

Lists lists_of_transfer(const Experiment& experiment) {
  if (experiment.groups.empty()) {
    throw Error(Exit::usage,
                "make transfer: [transfer] of pipeline/protocol.toml does not name a group of data "
                "sets; add one");
  }
  return lists_of(experiment.groups, experiment);
}

/// Returns the groups that name one of the data sets; all groups if a data set is in none.
std::vector<settings::Group> groups_of(const Words& datasets, const Experiment& experiment) {
  std::set<std::string> found;
  std::vector<settings::Group> groups;
  for (const settings::Group& group : experiment.groups) {
    bool any = false;
    for (const std::string& dataset : datasets) {
      if (!has(group.datasets, dataset)) continue;
      found.insert(dataset);
      any = true;
    }
    if (any) groups.push_back(group);
  }
  return found.size() == datasets.size() ? groups : experiment.groups;
}

/// True if one of the groups shows a method by this classifier that is not a ceiling.
bool judges_methods(const std::vector<settings::Group>& groups, const std::string& classifier) {
  return std::ranges::any_of(groups, [&](const settings::Group& group) {
    return std::ranges::any_of(augment::catalogue(), [&](const augment::CatalogueEntry& entry) {
      return !augment::is_ceiling(entry.name) && group.choices.shows(entry.name, classifier);
    });
  });
}

bool is_transfer(const Experiment& experiment, const std::string& name) {
  const Dataset* const dataset = experiment.find(name);
  return dataset != nullptr && dataset->is_transfer;
}

Lists lists_of_grid(const Words& goals) {
  Lists lists{.datasets = {"cwru"},
              .methods = default_methods(),
              .ratios = names_of_ratios(),
              .classifiers = {scoring::paper_classifier},
              .seeds = {}};
  if (goals == Words{"identify"}) {
    lists.datasets = {"simulated"};
    lists.methods = {"piae-dt", "piae-dt-phase"};
  }
  if (has(goals, "readings")) {
    lists.datasets = {"cwru", "hit-sm", "simulated"};
    lists.methods = {augment::paper_method()};
  }
  return lists;
}

}  // namespace

Words methods_of_paper() {
  Words methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_the_papers(entry)) methods.emplace_back(entry.name);
  }
  return methods;
}

Lists default_lists(const Experiment& experiment, const std::vector<std::string>& goals) {
  if (goals == Words{"verdicts"}) return lists_of_verdicts();
  Lists lists = has(goals, "transfer") ? lists_of_transfer(experiment) : lists_of_grid(goals);
  if (has(goals, "readings")) {
    lists.seeds = {100, 101, 102, 103, 104};  // choices are made on these seeds
  } else {
    lists.seeds = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  }
  return lists;
}

void take_rivals(const Experiment& experiment, const Words& goals, Lists& lists) {
  const Words with_own_lists{"sweep", "readings", "identify", "contrast", "transfer", "verdicts"};
  const bool may = std::ranges::none_of(
      goals, [&](const std::string& goal) { return has(with_own_lists, goal); });
  const bool all = std::ranges::all_of(
      lists.datasets, [&](const std::string& name) { return is_transfer(experiment, name); });
  if (!may || !all || experiment.groups.empty()) return;
  const std::vector<settings::Group> groups = groups_of(lists.datasets, experiment);
  Lists rivals = lists_of(groups, experiment);
  // Diffusion models and flows take minutes a seed, for windows that never helped at another speed.
  std::erase_if(rivals.methods, [](const std::string& name) {
    const augment::CatalogueEntry& entry = *augment::find_entry(name);
    return entry.kind == augment::Kind::control && entry.trains;
  });
  std::erase_if(rivals.classifiers,
                [&](const std::string& name) { return !judges_methods(groups, name); });
  lists.methods = std::move(rivals.methods);
  lists.ratios = std::move(rivals.ratios);
  lists.classifiers = std::move(rivals.classifiers);
}

}  // namespace piae::plan
