#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Returns "Faults are known at 1200 rpm, and tested at 900 rpm.", or "No fault window was known.";
/// "" if faults are tested in the conditions in which they are known.
std::string conditions_note(const run::Results& results);

/// Returns "By fault type: none 62.5 (100:1), vae 80.0 (2:1).", the mean accuracy of each
/// method at its ratio with the most generated windows. Returns "" for data sets without fault
/// types.
std::string types_sentence(const ClassifierRows& block);

/// Returns the most accurate method, rule and ceiling of a run without known fault windows, which
/// has no baseline for gains: "Right in most test windows: with generated windows vae by nearest
/// (81.2 %, 1:1) and by a rule envelope-rule (70.1 %)." Returns "" if `rows` is empty.
std::string most_accurate_without_known(const std::vector<AccuracyRow>& rows);

/// Effect of generated windows: the side of zero on which the interval of the mean lies. One or two
/// seeds have no interval and no clear difference.
enum class Effect { helps, no_clear_difference, harms };
Effect effect_of(const AccuracyRow& gain);

/// Returns the findings in sentences. First: which methods help and by how many points, at the
/// ratio with the most generated windows that most methods have. Then, if the paper's method is
/// there and gains little: why. Last, if known: the accuracy of the reference without generated
/// windows. All findings are by the paper's classifier, or else by the first classifier. All
/// numbers come from the run. `rows` are accuracy_rows() of `results`. Returns nothing if no row
/// can be compared with `none`.
std::vector<std::string> verdict(const run::Results& results, const std::vector<AccuracyRow>& rows);

}  // namespace piae::report
