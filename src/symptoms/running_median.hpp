#pragma once

#include <Eigen/Core>

namespace piae::symptoms {

/// The median of each number and of those near it, `width` in all, an odd number. Beyond either end
/// the array goes on as its mirror image, the last number twice. It must hold at least `width` / 2
/// numbers.
Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width);

}  // namespace piae::symptoms
