#pragma once

#include "cli/options.hpp"

namespace piae::twin {

/// How alpha, beta and gamma of eq. 23 are found (paper 4.5.5, Fig. 19c).
enum class LossWeights {
  adaptive,              ///< learned by eq. 23 as it stands
  adaptive_without_log,  ///< learned by eq. 23 without its logarithms, so that they only shrink
  fixed,                 ///< not learned: all three stay at 1
};

/// Which of its parameters a training hands to the generation.
enum class Keep {
  best,   ///< those after the epoch whose batches had the lowest mean of L_Rec + L_DDL + L_DT
  final,  ///< those after the last epoch
};

/// The word for it on the command line and in a stored model, where it also names the group of the
/// weights.
const char* to_string(Keep keep);

/// The settings of PIAE-DT. "Table 4" is a table of the paper; "open" means that the paper does not
/// say.
struct TwinOptions {
  int epochs = 200;                ///< Table 4
  int batch = 5;                   ///< Table 4
  double learning_rate = 5e-4;     ///< Table 4, eta_1 = eta_2 of eqs 24 and 25
  int decay_every = 50;            ///< epochs, Table 4 (StepLR step)
  double decay = 0.5;              ///< factor, Table 4 (StepLR gamma)
  double max_gradient_norm = 1.0;  ///< Table 4
  int depth = 3;                   ///< layers of each network (paper 4.5.5: 3 to 4)
  int width = 256;                 ///< units of a hidden dense layer; open in the paper
  int stage_epochs = 1;            ///< epochs in Stage 1, then in Stage 2; open in the paper
  int space_bins = 10;             ///< of the histogram, for k and for c; open in the paper
  LossWeights loss_weights = LossWeights::adaptive;
  Keep keep = Keep::best;     ///< open: the paper trains both and does not say which generates
  double mass_kg = 1.0;       ///< M of eq. 22; open, working set of the project's notes
  double load_n = 1000.0;     ///< W of eq. 22; open, working set
  double clearance_um = 2.0;  ///< gamma of eq. 11; open, working set
};

void bind(const cli::Options& command, TwinOptions& options);

}  // namespace piae::twin
