#pragma once

#include <string>

#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// By which share a speed may differ from the nearest at which a classifier knows faults: the loads
/// of CWRU's records alone make 4 %.
inline constexpr double speed_tolerance = 0.05;

/// Throws Error(bad_input), which begins with `what`, for a signal sampled more slowly than what
/// the classifier was trained on (a faster one is resampled), and for a speed beyond the tolerance
/// from all at which faults were known or generated.
void require_fitting_signal(const signal::DatasetInfo& trained, double sample_rate_hz,
                            double shaft_speed_rpm, const std::string& what);

}  // namespace piae::diagnosis
