#include "plan/request.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "diagnosis/catalogue.hpp"
#include "plan/goals.hpp"
#include "plan/words.hpp"
#include "scoring/ratios.hpp"

namespace piae::plan {

namespace {

[[noreturn]] void refuse(const std::string& variable, const std::string& what) {
  throw Error(Exit::usage, variable + ": " + what);
}

void require_words(const std::string& variable, const Words& words, const Words& known) {
  if (words.empty()) refuse(variable, "is empty");
  for (const std::string& word : words) {
    if (!known.empty() && !has(known, word)) {
      refuse(variable, fmt::format("unknown '{}'; there are: {}", word, spaced(known)));
    }
  }
  if (std::set<std::string>(words.begin(), words.end()).size() < words.size()) {
    refuse(variable, fmt::format("'{}' names one twice", spaced(words)));
  }
}

template <class Entries>
Words names_of(const Entries& entries) {
  Words names;
  for (const auto& entry : entries) names.emplace_back(entry.name);
  return names;
}

Words names_of_classifiers() {
  Words names;
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    names.emplace_back(classifier.name);
  }
  return names;
}

bool is_the_papers(const augment::CatalogueEntry& method) {
  using augment::Kind;
  return method.kind == Kind::baseline || method.kind == Kind::published ||
         method.kind == Kind::ablation;
}

Words methods_of_paper() {
  Words methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_the_papers(entry)) methods.emplace_back(entry.name);
  }
  return methods;
}

Words default_methods() {
  Words methods;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (is_the_papers(entry) || entry.recommended) methods.emplace_back(entry.name);
  }
  return methods;
}

/// Replaces the word `paper` by the paper's methods.
Words spelled_out(const Words& words) {
  Words methods;
  for (const std::string& word : words) {
    if (word != "paper") {
      methods.push_back(word);
      continue;
    }
    std::ranges::copy(methods_of_paper(), std::back_inserter(methods));
  }
  return methods;
}

bool is_goal(const Request& request, const std::string& goal) { return has(request.goals, goal); }

/// The defaults of `make transfer`: all groups, their methods by all inputs of a WDCNN and by the
/// bar, with the most generated windows.
struct OfTransfer {
  Words datasets;
  Words methods;
  Words ratios;
  Words classifiers;
};

OfTransfer defaults_of_transfer(const Experiment& experiment) {
  if (experiment.groups.empty()) {
    throw Error(Exit::usage,
                "make transfer: [transfer] of pipeline/protocol.toml names no group of data sets");
  }
  OfTransfer defaults;
  std::set<std::string> methods;
  std::set<std::string> datasets;
  for (const settings::Group& group : experiment.groups) {
    datasets.insert(group.datasets.begin(), group.datasets.end());
    for (const std::string& input : group.inputs) methods.insert(input.substr(0, input.find('=')));
  }
  for (const Dataset& dataset : experiment.datasets) {
    if (datasets.contains(dataset.name)) defaults.datasets.push_back(dataset.name);
  }
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (methods.contains(entry.name)) defaults.methods.emplace_back(entry.name);
  }
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    if (ratio.generated_per_class == 0) defaults.ratios.emplace_back(ratio.name);
  }
  defaults.ratios.emplace_back(scoring::all_ratios().back().name);
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    const bool is_wdcnn = classifier.represent != nullptr;
    if (is_wdcnn || std::string(classifier.name) == diagnosis::bar_classifier) {
      defaults.classifiers.emplace_back(classifier.name);
    }
  }
  return defaults;
}

/// Chooses the lists that are not given.
void choose_defaults(const Experiment& experiment, const Request& request, Choice& choice,
                     Words& datasets) {
  datasets = {"cwru"};
  choice.methods = default_methods();
  choice.ratios = names_of(scoring::all_ratios());
  choice.classifiers = {scoring::paper_classifier};
  choice.seeds = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  if (request.goals == Words{"identify"}) {
    datasets = {"simulated"};
    choice.methods = {"piae-dt", "piae-dt-phase"};
  }
  if (is_goal(request, "readings")) {
    datasets = {"cwru", "hit-sm", "simulated"};
    choice.methods = {augment::paper_method()};
    choice.seeds = {100, 101, 102, 103, 104};
  }
  if (is_goal(request, "transfer")) {
    OfTransfer defaults = defaults_of_transfer(experiment);
    datasets = std::move(defaults.datasets);
    choice.methods = std::move(defaults.methods);
    choice.ratios = std::move(defaults.ratios);
    choice.classifiers = std::move(defaults.classifiers);
  }
}

std::vector<std::int64_t> seeds_in(const std::string& text) {
  const Words words = words_in(text);
  require_words("SEEDS", words, {});
  std::vector<std::int64_t> seeds;
  for (const std::string& word : words) {
    const auto seed = number_in<std::int64_t>(word);
    if (!seed || *seed < 0 || std::to_string(*seed) != word) {
      refuse("SEEDS", fmt::format("whole numbers from 0 up, not '{}'", spaced(words)));
    }
    seeds.push_back(*seed);
  }
  std::ranges::sort(seeds);
  return seeds;
}

std::string run_name(const Request& request) {
  std::string name = request.run;
  if (name.starts_with("results/")) name = name.substr(std::string("results/").size());
  while (name.ends_with('/')) name.pop_back();
  if (words_in(name) != Words{name}) {
    refuse("RUN", "one word, the name of a folder under results/");
  }
  if (name.find('/') != std::string::npos) {
    refuse("RUN", fmt::format("the name of a folder under results/, not a path: '{}'", name));
  }
  if (has({".", "..", "published", "reference"}, name)) {
    refuse("RUN", fmt::format("'{}' cannot be the name of a run", name));
  }
  return name;
}

/// Names what a description must say for a method to run.
const char* in_words(augment::Needs need) {
  switch (need) {
    case augment::Needs::bearing:
      return "[bearing]";
    case augment::Needs::rhythm:
      return "faults in a raceway or a ball (not \"other\")";
    default:
      return "defect_size_mm of every fault";
  }
}

Words that_can_run(const Words& methods, const Dataset& dataset) {
  Words able;
  std::ranges::copy_if(methods, std::back_inserter(able), [&](const std::string& method) {
    const augment::CatalogueEntry* const entry = augment::find_entry(method);
    return entry == nullptr || can_run(*entry, dataset);
  });
  return able;
}

std::string unsaid_line(const Dataset& dataset) {
  Words unsaid;
  for (const augment::Needs need : dataset.unsaid) unsaid.emplace_back(in_words(need));
  return fmt::format("the description of {} does not say what they need: {}", dataset.name,
                     fmt::join(unsaid, " and "));
}

/// Requires that every method can run that was named; notes the others that are left out.
Words able_methods(const Words& methods, const Dataset& dataset, bool named, Words& notices) {
  Words able = that_can_run(methods, dataset);
  if (able.size() == methods.size()) return able;
  Words unable;
  std::ranges::copy_if(methods, std::back_inserter(unable),
                       [&](const std::string& method) { return !has(able, method); });
  if (named) {
    refuse("METHODS", fmt::format("{} cannot be run; {}; choose METHODS=\"{}\"", spaced(unable),
                                  unsaid_line(dataset), spaced(able)));
  }
  notices.push_back(fmt::format("left out: {}; {}", spaced(unable), unsaid_line(dataset)));
  return able;
}

bool any_together(const std::string& name, const Words& methods, const Words& classifiers,
                  bool any_known) {
  return std::ranges::any_of(methods, [&](const std::string& method) {
    return std::ranges::any_of(classifiers, [&](const std::string& classifier) {
      return (name == method || name == classifier) &&
             run::go_together(method, classifier, !any_known);
    });
  });
}

/// Says which methods and classifiers have no cells in a data set, and why; empty where all have.
std::string left_out_line(const Words& methods, const Words& classifiers, const Dataset& dataset) {
  Words not_here;
  Words nowhere;
  for (const Words& names : {methods, classifiers}) {
    for (const std::string& name : names) {
      if (any_together(name, methods, classifiers, dataset.any_known)) continue;
      (any_together(name, methods, classifiers, true) ? not_here : nowhere).push_back(name);
    }
  }
  Words reasons;
  if (!not_here.empty()) {
    reasons.push_back(fmt::format("no fault window is known, so these are left out: {}",
                                  fmt::join(not_here, ", ")));
  }
  if (!nowhere.empty()) {
    reasons.push_back(fmt::format("rules are run with {} alone, so these are left out: {}",
                                  augment::no_method, fmt::join(nowhere, ", ")));
  }
  return reasons.empty() ? "" : fmt::format("{}", fmt::join(reasons, " "));
}

[[noreturn]] void refuse_no_cells(const Choice& choice) {
  throw Error(
      Exit::usage,
      fmt::format("no cells: METHODS=\"{}\" RATIOS=\"{}\"; {} is run at {} only, the others "
                  "at all other ratios",
                  spaced(choice.methods), spaced(choice.ratios), augment::no_method,
                  scoring::all_ratios().front().name));
}

[[noreturn]] void refuse_nothing_left(const Dataset& dataset, const std::string& reasons) {
  Words methods;
  Words classifiers;
  for (const augment::CatalogueEntry& method : augment::catalogue()) {
    for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
      if (!run::go_together(method, classifier, !dataset.any_known)) continue;
      if (!has(methods, method.name)) methods.emplace_back(method.name);
      if (!has(classifiers, classifier.name)) classifiers.emplace_back(classifier.name);
    }
  }
  throw Error(Exit::usage,
              fmt::format("{}: nothing is left to be made; {}; choose of METHODS=\"{}\" "
                          "CLASSIFIERS=\"{}\"",
                          dataset.name, reasons, spaced(methods), spaced(classifiers)));
}

/// The methods of these that have any of these ratios.
Words with_ratios(const Words& methods, const Words& ratios) {
  Words kept;
  std::ranges::copy_if(methods, std::back_inserter(kept), [&](const std::string& method) {
    return std::ranges::any_of(ratios, [&](const std::string& ratio) {
      return run::go_together(method, scoring::find_ratio(ratio));
    });
  });
  return kept;
}

Part part_of(const Dataset& dataset, const Words& methods, Choice& choice) {
  const std::string reasons = left_out_line(methods, choice.classifiers, dataset);
  run::GridOptions options{.dataset = dataset.name,
                           .methods = methods,
                           .ratios = choice.ratios,
                           .seeds = {"0"},
                           .classifiers = choice.classifiers};
  if (!dataset.any_known) options.nothing_known = {dataset.name};
  Part part{.dataset = dataset, .cells = {}, .methods = {}};
  try {
    part.cells = run::resolve(options).combinations;
  } catch (const Error&) {
    refuse_nothing_left(dataset, reasons);
  }
  if (!reasons.empty()) choice.notices.push_back(dataset.name + ": " + reasons);
  std::ranges::copy_if(methods, std::back_inserter(part.methods), [&](const std::string& method) {
    return std::ranges::count(part.cells, method, &run::Combination::method) > 0;
  });
  return part;
}

void choose_goals(const Request& request, Choice& choice) {
  for (const std::string& goal : request.goals) {
    const bool is_file = goal.find('/') != std::string::npos;
    if (!is_file && !has(goal_names(), goal)) {
      throw Error(Exit::usage, fmt::format("there is no goal '{}'; there are: {}, and files of "
                                           "results/",
                                           goal, spaced(goal_names())));
    }
    (is_file ? choice.files : choice.goals).push_back(goal);
  }
  choice.only_looks =
      choice.files.empty() && std::ranges::all_of(choice.goals, [](const auto& goal) {
        return goal == "figures" || goal == "report";
      });
}

/// Takes the lists that are given in the place of the defaults.
void take_given(const Request& request, Choice& choice) {
  const auto note = [&](const std::string& option, const Words& words) {
    choice.given.push_back("--" + option);
    choice.given.insert(choice.given.end(), words.begin(), words.end());
  };
  if (request.methods) {
    choice.methods = spelled_out(words_in(*request.methods));
    note("methods", choice.methods);
  }
  if (request.ratios) {
    choice.ratios = words_in(*request.ratios);
    note("ratios", choice.ratios);
  }
  if (request.classifiers) {
    choice.classifiers = words_in(*request.classifiers);
    note("classifiers", choice.classifiers);
  }
  if (request.seeds) {
    choice.seeds = seeds_in(*request.seeds);
    note("seeds", words_in(*request.seeds));
  }
  require_words("METHODS", choice.methods, names_of(augment::catalogue()));
  require_words("RATIOS", choice.ratios, names_of(scoring::all_ratios()));
  require_words("CLASSIFIERS", choice.classifiers, names_of_classifiers());
  choice.ratios_given = request.ratios.has_value();
  choice.lowest_seed = std::ranges::min(choice.seeds);
}

}  // namespace

bool Choice::has_goal(const std::string& name) const { return has(goals, name); }

std::string Choice::folder_of(signal::Protocol of) const {
  return "results/" + run + (of == signal::Protocol::blocked ? "-blocked" : "");
}

Choice choose(const Experiment& experiment, const Request& request) {
  Choice choice;
  choice.run = run_name(request);
  choice.protocol = request.protocol;
  choice.data_dir = request.data_dir;
  choose_goals(request, choice);
  Words datasets;
  choose_defaults(experiment, request, choice, datasets);
  if (choice.only_looks && !request.held.empty()) datasets = request.held;
  if (request.datasets) datasets = words_in(*request.datasets);
  require_words("DATASETS", datasets, names_of(experiment.datasets));
  take_given(request, choice);
  const Words methods = with_ratios(choice.methods, choice.ratios);
  if (methods.empty() && !choice.only_looks) refuse_no_cells(choice);
  for (const std::string& name : datasets) {
    const Dataset& dataset = *experiment.find(name);
    if (choice.only_looks) {
      choice.parts.push_back({.dataset = dataset, .cells = {}, .methods = {}});
      continue;
    }
    const Words able = able_methods(methods, dataset, request.methods.has_value(), choice.notices);
    choice.parts.push_back(part_of(dataset, able, choice));
  }
  return choice;
}

}  // namespace piae::plan
