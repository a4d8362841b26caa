#pragma once

#include "cli/options.hpp"
#include "phase/inference_options.hpp"
#include "twin/options.hpp"

namespace piae::phase {

/// Settings of piae-dt-phase: those of the twin, whose mass, load and clearance are also the
/// simulations', and those of the inference.
struct PhaseOptions {
  twin::TwinOptions twin;
  InferenceOptions inference;
};

void bind(const cli::Options& command, PhaseOptions& options);

}  // namespace piae::phase
