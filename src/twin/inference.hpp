#pragma once

#include <vector>

#include "artefact/reader.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// The stiffness (N/m) and damping (N s/m) that the encoder of a stored model (eq. 16) infers of
/// each window. Windows are scaled by their class, as those of the training were.
/// Throws Error(bad_input) for windows of another length or of other classes than the model's.
std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const TwinVariant& variant,
                                             const signal::WindowSet& windows,
                                             const Engine& engine);

}  // namespace piae::twin
