#pragma once

#include <string>

#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// Largest relative difference of a speed from the nearest one at which a classifier knows faults.
/// The loads of CWRU's records alone make 4 %.
inline constexpr double speed_tolerance = 0.05;

/// Throws Error(bad_input), which begins with `what`, if the signal does not fit the classifier:
/// its sample rate is below that of the training (a faster signal is resampled), or its speed is
/// farther than the tolerance from all speeds at which faults were known or generated.
void require_fitting_signal(const signal::DatasetInfo& trained, double sample_rate_hz,
                            double shaft_speed_rpm, const std::string& what);

}  // namespace piae::diagnosis
