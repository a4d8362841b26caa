#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/random.hpp"

namespace piae::zero {

/// Knots of a random path, from 0 Hz to half the sampling rate: 0.75 kHz apart at 12 kHz.
inline constexpr int path_knots = 9;

/// A healthy window with the mean 0 and the mean square 1; every second time, by chance, it runs
/// backwards: it has the same spectrum then, and is not the same window. What it hears goes through
/// a random smooth path (transfer/equaliser.hpp) whose gain at a knot has this standard deviation.
Eigen::ArrayXd draw_background(std::span<const float> healthy, double spread_db, Stream& random);

/// As loud as the healthy window: the same standard deviation, and the mean 0. Of how loud a fault
/// is, nothing is known, and classifiers standardise. A window in which nothing moves stays so.
std::vector<float> as_loud_as(std::span<const float> healthy, const Eigen::ArrayXd& window);

}  // namespace piae::zero
