#pragma once

#include <filesystem>
#include <vector>

#include "regression/measurements.hpp"
#include "run/selection.hpp"

namespace piae::regression {

/// The numbers of all selected diagnoses and scores of a run: an entry for each dataset that has
/// any, in alphabetical order, with its values by method, ratio, classifier, quantity and seed.
/// Each file is opened once. Throws Error(input_missing) when the run has no such cell, and
/// Error(bad_input) for a cell that is damaged, that is another one than its place says, or that
/// has another split protocol than the cells before it.
std::vector<Measurements> read_run(const std::filesystem::path& run,
                                   const run::Selection& selection);

}  // namespace piae::regression
