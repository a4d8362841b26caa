#include "plan/request.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "diagnosis/catalogue.hpp"
#include "plan/default_lists.hpp"
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
      refuse(variable, fmt::format("unknown '{}'; choose from: {}", word, spaced(known)));
    }
  }
  if (std::set<std::string>(words.begin(), words.end()).size() < words.size()) {
    refuse(variable, fmt::format("'{}' names the same item twice; remove one", spaced(words)));
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

std::vector<std::int64_t> seeds_in(const std::string& text) {
  const Words words = words_in(text);
  require_words("SEEDS", words, {});
  std::vector<std::int64_t> seeds;
  for (const std::string& word : words) {
    const auto seed = number_in<std::int64_t>(word);
    if (!seed || *seed < 0 || std::to_string(*seed) != word) {
      refuse("SEEDS", fmt::format("must be whole numbers from 0 up, not '{}'", spaced(words)));
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
    refuse("RUN", "must be one word, the name of a folder under results/");
  }
  if (name.find('/') != std::string::npos) {
    refuse("RUN",
           fmt::format("must be the name of a folder under results/, not a path: '{}'", name));
  }
  const bool begins_badly = name.starts_with('.') || name.starts_with('-');
  if (begins_badly || has({"published", "reference", "results"}, name)) {
    refuse("RUN",
           fmt::format("'{}' cannot be the name of a run; choose another one, such as try", name));
  }
  return name;
}

[[noreturn]] void refuse_no_cells(const Choice& choice) {
  throw Error(Exit::usage, fmt::format("no cells: METHODS=\"{}\" RATIOS=\"{}\"; {} runs at {} "
                                       "only, and the other methods at all other ratios",
                                       spaced(choice.methods), spaced(choice.ratios),
                                       augment::no_method, scoring::all_ratios().front().name));
}

/// Handles figures and pages that are requested as files. Then only the named figures are drawn.
void take_looks(const Words& files, Choice& choice) {
  bool draws_all = std::ranges::any_of(
      choice.goals, [](const std::string& name) { return goal_named(name).draws; });
  Words pictures;
  for (const std::string& file : files) {
    const Goal& goal = goal_of_file(file);
    draws_all = draws_all || goal.writes_pages;
    if (!file.ends_with(".csv")) pictures.push_back(file);
    if (!choice.has_goal(goal.name)) choice.goals.push_back(goal.name);
  }
  if (!files.empty() && !draws_all) choice.only_pictures = std::move(pictures);
}

void choose_goals(const Request& request, Choice& choice) {
  Words looks;
  for (const std::string& goal : request.goals) {
    const bool is_file = goal.find('/') != std::string::npos;
    if (!is_file && !has(goal_names(), goal)) {
      throw Error(Exit::usage,
                  fmt::format("unknown goal '{}'; choose from: {}, or name a file of results/",
                              goal, spaced(goal_names())));
    }
    if (!is_file) {
      choice.goals.push_back(goal);
      continue;
    }
    const std::string file = std::filesystem::path(goal).lexically_normal();
    (goal_of_file(file).add != nullptr ? choice.files : looks).push_back(file);
  }
  take_looks(looks, choice);
  choice.only_looks =
      choice.files.empty() && std::ranges::all_of(choice.goals, [](const std::string& name) {
        return goal_named(name).add == nullptr;
      });
}

/// Takes the given lists instead of the defaults.
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
  choice.classifiers_given = request.classifiers.has_value();
  choice.lowest_seed = std::ranges::min(choice.seeds);
}

/// Notes which data sets are compared by the paper's methods although faults are known in another
/// condition, because other data sets are requested, too.
void note_lacking_rivals(const Experiment& experiment, const Words& datasets, Notices& notices) {
  Words transfers;
  std::ranges::copy_if(datasets, std::back_inserter(transfers),
                       [&](const std::string& name) { return experiment.find(name)->is_transfer; });
  if (transfers.size() == datasets.size()) return;
  for (const std::string& name : transfers) {
    notices.push_back({name,
                       "faults are known in another condition; request such data sets alone, or "
                       "name METHODS, to compare the rivals of [transfer] in the protocol"});
  }
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
  Lists lists = default_lists(experiment, request.goals);
  if (choice.only_looks && !request.held.empty()) lists.datasets = request.held;
  if (request.datasets) lists.datasets = words_in(*request.datasets);
  require_words("DATASETS", lists.datasets, names_of(experiment.datasets));
  take_rivals(experiment, request.goals, lists);
  choice.methods = std::move(lists.methods);
  choice.ratios = std::move(lists.ratios);
  choice.classifiers = std::move(lists.classifiers);
  choice.seeds = std::move(lists.seeds);
  take_given(request, choice);
  const RequestedForAll requested{.methods = with_ratios(choice.methods, choice.ratios),
                                  .ratios = choice.ratios,
                                  .classifiers = choice.classifiers,
                                  .methods_are_named = request.methods.has_value()};
  if (requested.methods.empty() && !choice.only_looks) refuse_no_cells(choice);
  Notices notices;
  if (!request.methods && !choice.only_looks) {
    note_lacking_rivals(experiment, lists.datasets, notices);
  }
  for (const std::string& name : lists.datasets) {
    const Dataset& dataset = *experiment.find(name);
    choice.parts.push_back(choice.only_looks ? Part{.dataset = dataset, .cells = {}, .methods = {}}
                                             : part_of(dataset, requested, notices));
  }
  choice.notices = notice_lines(notices);
  return choice;
}

}  // namespace piae::plan
