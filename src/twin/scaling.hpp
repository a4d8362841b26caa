#pragma once

#include <torch/types.h>

#include <vector>

#include "signal/window_set.hpp"

namespace piae::twin {

/// RMS of each class's windows about their means, in the recordings' unit: the a_ref by which the
/// twin makes acceleration dimensionless. 1 for a class without windows, such as the healthy one.
/// Throws Error(bad_input) for a class whose windows are constant.
std::vector<double> rms_by_class(const signal::WindowSet& windows);

/// Windows without their means (a sensor's offset is no vibration) and divided by their class's
/// scale: float32 [n, N].
torch::Tensor scaled_windows(const signal::WindowSet& windows, const std::vector<double>& scale);

}  // namespace piae::twin
