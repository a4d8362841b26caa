#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"
#include "run/collect.hpp"

namespace piae::report {

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
