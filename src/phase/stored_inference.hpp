#pragma once

#include <memory>
#include <vector>

#include "artefact/reader.hpp"
#include "phase/inference.hpp"
#include "signal/window_set.hpp"

namespace piae::phase {

/// Returns the inference of a stored model. Throws artefact::Refusal if it is missing
/// or has other shapes.
std::unique_ptr<Inference> read_inference(const artefact::Reader& model);

/// Returns the stiffness (N/m) and damping (N s/m) that a stored model of piae-dt-phase infers for
/// each window (inference.hpp). Throws Error(bad_input) like Inference::infer, and if the number of
/// classes differs from the model's.
std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const signal::WindowSet& windows);

}  // namespace piae::phase
