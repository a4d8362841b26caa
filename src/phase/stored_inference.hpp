#pragma once

#include <memory>
#include <vector>

#include "artefact/reader.hpp"
#include "phase/inference.hpp"
#include "signal/window_set.hpp"

namespace piae::phase {

/// The inference of a stored model. Throws artefact::Refusal for what no training has written.
std::unique_ptr<Inference> read_inference(const artefact::Reader& model);

/// The stiffness (N/m) and damping (N s/m) that a stored model of piae-dt-phase infers of each
/// window (inference.hpp). Throws Error(bad_input) as Inference::infer does, and for windows of
/// another number of classes than the model's.
std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                             const signal::WindowSet& windows);

}  // namespace piae::phase
