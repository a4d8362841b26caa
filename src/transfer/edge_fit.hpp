#pragma once

#include <Eigen/Core>
#include <vector>

#include "impacts/edges.hpp"

namespace piae::transfer {

/// Measurements of one bearing in one condition.
struct SeenBearing {
  Eigen::ArrayXd log_amplitude;  ///< natural logarithm of its windows' mean spectrum, by bin
  double passage_s =
      0;  ///< time that a ball takes to pass the defect (bearing/impact_frequency.hpp)
};

/// The bins of a spectrum in which the edges are searched.
struct Band {
  double bin_hz = 0;       ///< bin spacing
  Eigen::Index first = 0;  ///< bin
  Eigen::Index last = 0;   ///< bin, included
};

/// Assumed edges where spectra are not conclusive. The lag is a fraction of the passage, because
/// the ball hits the second edge a little before its centre is over it.
struct EdgePrior {
  double share = 0.9;
  double share_deviation = 0.08;
  double exit = 0.6;
  double exit_deviation = 0.25;
  double weight = 0.02;  ///< weight of squared deviations against the relative squared error
};

/// Separates the edges of each bearing from the structure, which all bearings share. The model is
///  log|Y_b(f)| = S(f) + T_b(f) + log|E_b(f)|,
/// where S is the structure, an arbitrary curve fixed in Hz. T_b is smooth (five cosines over the
/// band): the level and the colour of this bearing's impacts. E_b is that of Edges. Lag, exit and
/// spread are searched on a grid, bearing by bearing, with S as the mean of what the others leave,
/// until nothing changes. A bearing whose lag leaves no minimum within the band, or that is the
/// only bearing, gets the prior. Edges are in the order of the bearings.
std::vector<impacts::Edges> fit_edges(const std::vector<SeenBearing>& bearings, const Band& band,
                                      const EdgePrior& prior);

}  // namespace piae::transfer
