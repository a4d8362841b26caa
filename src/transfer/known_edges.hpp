#pragma once

#include <vector>

#include "signal/window_set.hpp"
#include "transfer/edge_fit.hpp"

namespace piae::transfer {

/// The edges of the defect in each known window, in the order of the windows. Windows of one class,
/// speed and size are of one bearing. Its spectrum is Welch's, of pieces of half a window that
/// overlap by three quarters; the band reaches from 2 % of half the sampling rate to the 91 % that
/// resampling leaves.
std::vector<Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior);

}  // namespace piae::transfer
