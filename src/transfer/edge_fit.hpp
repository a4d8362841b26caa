#pragma once

#include <Eigen/Core>
#include <vector>

#include "impacts/edges.hpp"

namespace piae::transfer {

/// What is seen of one bearing in one condition.
struct SeenBearing {
  Eigen::ArrayXd log_amplitude;  ///< of its windows' mean spectrum: natural logarithm, by bin
  double passage_s = 0;          ///< how long a ball is over the defect (bearing/strikes.hpp)
};

/// The bins of a spectrum in which the edges are looked for.
struct Band {
  double bin_hz = 0;       ///< from bin to bin
  Eigen::Index first = 0;  ///< bin
  Eigen::Index last = 0;   ///< bin, included
};

/// What edges are taken to be where spectra do not say otherwise. The lag is given as a share of
/// the passage: the ball strikes the second edge a little before its centre is over it.
struct EdgePrior {
  double share = 0.9;
  double share_deviation = 0.08;
  double exit = 0.6;
  double exit_deviation = 0.25;
  double weight = 0.02;  ///< of a squared standard deviation beside the relative squared error
};

/// Tells the edges of each bearing from the structure, which all have in common. The model is
///   log|Y_b(f)| = S(f) + T_b(f) + log|E_b(f)|,
/// where S is the structure's, fixed in Hz and any curve at all; T_b is smooth, five cosines over
/// the band: loudness, and how the blow of this bearing is coloured; E_b is of Edges. Lag, exit and
/// spread are searched on a grid, bearing by bearing, with S as the mean of what the others leave,
/// until nothing changes. A bearing whose lag leaves no minimum within the band, or that has no
/// other beside it, gets what the prior says. Edges are in the order of the bearings.
std::vector<impacts::Edges> fit_edges(const std::vector<SeenBearing>& bearings, const Band& band,
                                      const EdgePrior& prior);

}  // namespace piae::transfer
