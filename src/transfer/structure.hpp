#pragma once

#include <Eigen/Core>
#include <vector>

#include "impacts/edges.hpp"
#include "signal/window_set.hpp"

namespace piae::transfer {

/// Response of the machine to one impact: the logarithm of its amplitude at the bins 0 .. length of
/// a frame of two windows, with the mean 0. It is the spectrum of the known windows without the
/// edges of their defects and without the lines of the impact rate.
struct Structure {
  Eigen::ArrayXd common;            ///< the mean over all bearings
  std::vector<Eigen::ArrayXd> own;  ///< for each known window: its bearing minus `common`
};

/// `edges` are those of each known window.
Structure structure_of(const signal::WindowSet& known, const std::vector<impacts::Edges>& edges);

}  // namespace piae::transfer
