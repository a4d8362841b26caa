#pragma once

#include <Eigen/Core>
#include <vector>

#include "transfer/edges.hpp"

namespace piae::transfer {

/// A ball that meets the defect: a blow at its first edge, and the other way at its second.
struct Strike {
  double time_s = 0;    ///< of the first blow
  double strength = 1;  ///< of the first blow
  double lag_s = 0;     ///< from the first blow to the second
  double exit = 0;      ///< second blow / first
};

/// The spectrum of a train of strikes at `bins` frequencies, `bin_hz` apart from 0 Hz on:
///   X(f) = sum of strength exp(-2 pi i f time) (1 - exit exp(-2 pi i f lag)).
Eigen::ArrayXcd excitation(const std::vector<Strike>& strikes, Eigen::Index bins, double bin_hz);

}  // namespace piae::transfer
