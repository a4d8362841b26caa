#pragma once

#include <filesystem>
#include <vector>

#include "regression/measurements.hpp"
#include "run/selection.hpp"

namespace piae::regression {

/// Returns the numbers of all selected diagnoses and scores of a run: an entry for each data set
/// that has any, in alphabetical order, with values sorted by method, ratio, classifier, quantity
/// and seed. Opens each file once. Throws Error(input_missing) if the run has no such cell, and
/// Error(bad_input) for a cell that is damaged, differs from its place in the run, or has another
/// split protocol than the cells before it.
std::vector<Measurements> read_run(const std::filesystem::path& run,
                                   const run::Selection& selection);

}  // namespace piae::regression
