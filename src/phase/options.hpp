#pragma once

#include "cli/options.hpp"
#include "phase/inference_options.hpp"
#include "twin/options.hpp"

namespace piae::phase {

/// The settings of piae-dt-phase: those of the twin, whose mass, load and clearance also serve the
/// simulations that the inference learns from, and those of the inference.
struct PhaseOptions {
  /// Its decoder learns in batches of all classes, with which its settings were calibrated.
  twin::TwinOptions twin{.batches = twin::Batches::mixed};
  InferenceOptions inference;
};

void bind(const cli::Options& command, PhaseOptions& options);

}  // namespace piae::phase
