#pragma once

#include <vector>

#include "bearing/dynamics.hpp"

namespace piae::bearing::reference {

/// Solves eq. 13 independently, one course at a time: with angles instead of rotations, every ball
/// instead of those ahead of the load zone's start, and Boost.odeint's Runge-Kutta. It is the
/// reference for bearing::simulate and does not check its arguments.
std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling);

}  // namespace piae::bearing::reference
