#pragma once

#include <vector>

#include "bearing/dynamics.hpp"

namespace piae::bearing::reference {

/// Eq. 13 again, one course at a time: angles instead of rotations, every ball instead of those
/// ahead of the load zone's begin, and Boost.odeint's Runge-Kutta. What bearing::simulate is
/// compared with; it takes no look at its arguments.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing::reference
