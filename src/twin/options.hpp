#pragma once

#include <string>

#include "cli/options.hpp"

namespace piae::twin {

/// Settings of PIAE-DT. "Table 4" is the paper's; what the paper leaves open is said so.
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
  /// How alpha, beta and gamma of eq. 23 are had (paper 4.5.5, Fig. 19c): "adaptive", learned with
  /// the equation as it stands; "adaptive-without-log", learned without its logarithms, by which
  /// they shrink towards zero throughout; "fixed" at 1.
  std::string loss_weights = "adaptive";
  std::string keep = "best";  ///< which model generates: "final", or "best" (after
                              ///< the epoch with the lowest mean of L_Rec + L_DDL + L_DT
                              ///< over its batches); open
  double mass_kg = 1.0;       ///< M of eq. 22; open, working set of the project's notes
  double load_n = 1000.0;     ///< W of eq. 22; open, working set
  double clearance_um = 2.0;  ///< gamma of eq. 11; open, working set
};

void bind(const cli::Options& command, TwinOptions& options);

}  // namespace piae::twin
