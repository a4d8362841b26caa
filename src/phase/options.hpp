#pragma once

#include "cli/options.hpp"
#include "phase/inference_options.hpp"
#include "twin/options.hpp"

namespace piae::phase {

/// Settings of piae-dt-phase: those of the twin and those of the inference. The twin's mass, load
/// and clearance also apply to the simulations from which the inference learns.
struct PhaseOptions {
  /// The decoder learns in batches of all classes, because its settings were calibrated with these.
  twin::TwinOptions twin{.batches = twin::Batches::mixed};
  InferenceOptions inference;
};

void bind(const cli::Options& command, PhaseOptions& options);

}  // namespace piae::phase
