#pragma once

#include <vector>

#include "artefact/reader.hpp"
#include "signal/window_set.hpp"

namespace piae::phase {

/// What a stored model of piae-dt-phase infers of windows (inference.hpp): stiffness in N/m and
/// damping in N s/m, one pair for each. Throws Error(bad_input) as Inference::infer, and for
/// windows of another number of classes than the model's.
std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const signal::WindowSet& windows);

}  // namespace piae::phase
