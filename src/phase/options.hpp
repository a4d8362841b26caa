#pragma once

#include "cli/options.hpp"
#include "phase/inference_options.hpp"
#include "twin/options.hpp"

namespace piae::phase {

/// The settings of piae-dt-phase: those of the twin, whose mass, load and clearance also serve the
/// simulations that the inference learns from, and those of the inference.
struct PhaseOptions {
  twin::TwinOptions twin;
  InferenceOptions inference;
};

void bind(const cli::Options& command, PhaseOptions& options);

}  // namespace piae::phase
