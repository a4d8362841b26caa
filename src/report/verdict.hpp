#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// "Faults are known at 1200 rpm, and tested at 900 rpm.", or "No fault window was known."; empty
/// where a run tests faults in the conditions in which they are known.
std::string conditions_note(const run::Results& results);

/// "By kind of defect: none 62.5 (100:1), vae 80.0 (2:1).": the mean accuracy of each method at its
/// ratio with the most generated windows. Empty where kinds are not told apart.
std::string kinds_sentence(const ClassifierRows& block);

/// What a run is worth in which no fault window was known, and so nothing is a gain over another:
/// the most accurate method, rule and ceiling. "Right in most test windows: with generated windows
/// vae by nearest (81.2 %, 1:1) and by a rule envelope-rule (70.1 %)." Empty where there is no row.
std::string most_accurate_without_known(const std::vector<AccuracyRow>& rows);

/// What generated windows are worth: whether the interval of the mean lies on one side of zero. One
/// or two seeds have none and tell nothing.
enum class Effect { helps, no_clear_difference, harms };
Effect effect_of(const AccuracyRow& gain);

/// What was seen, in sentences: which methods help and by how many points, at the ratio with the
/// most generated windows that most methods have; where the paper's method is there and gains
/// little, why; and what the bar reaches without any of this, where that is known. All by the
/// paper's classifier, or else the first of those there are. All numbers are those of the run.
/// `rows` are accuracy_rows() of these results. Empty where nothing can be compared with `none`.
std::vector<std::string> verdict(const run::Results& results, const std::vector<AccuracyRow>& rows);

}  // namespace piae::report
