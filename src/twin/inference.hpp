#pragma once

#include <vector>

#include "artefact/reader.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// Returns the stiffness (N/m) and damping (N s/m) that the encoder of a stored model (eq. 16)
/// infers from each window. Scales windows by their class, like those of the training. Throws
/// Error(bad_input) if the window length or the number of classes differs from the model's.
std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const TwinVariant& variant,
                                             const signal::WindowSet& windows,
                                             const Engine& engine);

}  // namespace piae::twin
