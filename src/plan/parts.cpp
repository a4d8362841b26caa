#include "plan/parts.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"
#include "plan/words.hpp"
#include "scoring/ratios.hpp"

namespace piae::plan {

namespace {

/// Names the keys that a description needs for a method to run.
const char* in_words(augment::Needs need) {
  switch (need) {
    case augment::Needs::bearing:
      return "[bearing]";
    case augment::Needs::impact_rate:
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

std::string what_is_unsaid(const Dataset& dataset) {
  Words unsaid;
  for (const augment::Needs need : dataset.unsaid) unsaid.emplace_back(in_words(need));
  return fmt::format("lacks what they need: {}", fmt::join(unsaid, " and "));
}

/// Requires that every named method can run. Leaves out the others, with a notice.
Words able_methods(const Words& methods, const Dataset& dataset, bool named, Notices& notices) {
  Words able = that_can_run(methods, dataset);
  if (able.size() == methods.size()) return able;
  Words unable;
  std::ranges::copy_if(methods, std::back_inserter(unable),
                       [&](const std::string& method) { return !has(able, method); });
  if (named) {
    throw Error(
        Exit::usage,
        fmt::format("METHODS: {} cannot be run; the description of {} {}; choose METHODS=\"{}\"",
                    spaced(unable), dataset.name, what_is_unsaid(dataset), spaced(able)));
  }
  notices.push_back({dataset.name, fmt::format("left out: {}; the description {}", spaced(unable),
                                               what_is_unsaid(dataset))});
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

/// Names the methods and classifiers without cells in a data set, and why; empty if there are none.
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
    reasons.push_back(fmt::format("rules run with {} only, so these are left out: {}",
                                  augment::no_method, fmt::join(nowhere, ", ")));
  }
  return reasons.empty() ? "" : fmt::format("{}", fmt::join(reasons, " "));
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
              fmt::format("{}: nothing is left to run; {}; choose from METHODS=\"{}\" "
                          "CLASSIFIERS=\"{}\"",
                          dataset.name, reasons, spaced(methods), spaced(classifiers)));
}

}  // namespace

Words notice_lines(const Notices& notices) {
  Words lines;
  Words texts;
  for (const Notice& notice : notices) {
    if (has(texts, notice.text)) continue;
    texts.push_back(notice.text);
    const auto others = std::ranges::count(notices, notice.text, &Notice::text) - 1;
    const std::string more = others > 0 ? fmt::format(" and {} more", others) : "";
    lines.push_back(fmt::format("{}{}: {}", notice.dataset, more, notice.text));
  }
  return lines;
}

Words with_ratios(const Words& methods, const Words& ratios) {
  Words kept;
  std::ranges::copy_if(methods, std::back_inserter(kept), [&](const std::string& method) {
    return std::ranges::any_of(ratios, [&](const std::string& ratio) {
      return run::go_together(method, scoring::find_ratio(ratio));
    });
  });
  return kept;
}

Part part_of(const Dataset& dataset, const RequestedForAll& requested, Notices& notices) {
  const Words methods =
      able_methods(requested.methods, dataset, requested.methods_are_named, notices);
  const std::string reasons = left_out_line(methods, requested.classifiers, dataset);
  run::GridOptions options{.dataset = dataset.name,
                           .methods = methods,
                           .ratios = requested.ratios,
                           .seeds = {"0"},
                           .classifiers = requested.classifiers};
  if (!dataset.any_known) options.nothing_known = {dataset.name};
  Part part{.dataset = dataset, .cells = {}, .methods = {}};
  try {
    part.cells = run::resolve(options).combinations;
  } catch (const Error&) {
    refuse_nothing_left(dataset, reasons);
  }
  if (!reasons.empty()) notices.push_back({dataset.name, reasons});
  std::ranges::copy_if(methods, std::back_inserter(part.methods), [&](const std::string& method) {
    return std::ranges::count(part.cells, method, &run::Combination::method) > 0;
  });
  return part;
}

}  // namespace piae::plan
