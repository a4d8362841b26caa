#pragma once

#include <filesystem>
#include <vector>

#include "regression/measurements.hpp"
#include "run/selection.hpp"

namespace piae::regression {

/// What the diagnoses and scores of a run give, for each dataset of the selection that has any, in
/// alphabetical order; values by method, ratio, quantity and seed. All are of one split protocol.
/// Throws Error(input_missing) when the run has no such cell, and Error(bad_input) for one that is
/// damaged, holds another cell than its place says, or is of another protocol.
std::vector<Measurements> read_run(const std::filesystem::path& run,
                                   const run::Selection& selection);

}  // namespace piae::regression
