#pragma once

#include <Eigen/Core>

namespace piae::trend {

/// Returns a window without its mean and without what lies above the watched frequencies
/// (rate_over_bandwidth). All bins above are 0, so the window is taken as periodic.
Eigen::RowVectorXd low_passed(const Eigen::RowVectorXd& window);

}  // namespace piae::trend
