#pragma once

#include <string>
#include <vector>

#include "report/classifier_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// "Faults are known at 1200 rpm, and tested at 900 rpm.", or "No fault window was known."; empty
/// where a run tests faults in the conditions in which they are known.
std::string conditions_note(const run::Results& results);

/// "By kind of defect: none 62.5 (100:1), vae 80.0 (2:1).": the mean accuracy of each method at its
/// ratio with the most generated windows. Empty where kinds are not told apart.
std::string kinds_sentence(const ClassifierRows& block);

}  // namespace piae::report
