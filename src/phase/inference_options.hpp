#pragma once

#include "cli/options.hpp"

namespace piae::phase {

/// Ranges of stiffness and damping in which the inference searches, and its training parameters.
/// The values were chosen on simulated windows with seed 100 (pipeline/protocol.toml).
struct InferenceOptions {
  double stiffness_from_n_per_m = 1e7;  ///< for the first round; the largest is load / clearance
  double damping_from_ns_per_m = 100;   ///< for the first round
  double damping_to_ns_per_m = 5000;    ///< for the first round
  int simulations = 3000;               ///< windows of each class in the last round
  int epochs = 40;                      ///< epochs per round
  int batch = 64;                       ///< windows in a step
  int width = 256;                      ///< units of a hidden layer
  double learning_rate = 1e-3;          ///< Adam's initial rate; falls to 0 along a cosine
  double snr_to_db = 30;  ///< noise is drawn from 0 dB (as strong as the signal) to this
};

void bind(const cli::Options& command, InferenceOptions& options);

}  // namespace piae::phase
