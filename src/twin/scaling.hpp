#pragma once

#include <torch/types.h>

#include <vector>

#include "signal/window_set.hpp"

namespace piae::twin {

/// Windows without their means (a sensor's offset is no vibration) and divided by their class's
/// scale: float32 [n, N].
torch::Tensor scaled_windows(const signal::WindowSet& windows, const std::vector<double>& scale);

}  // namespace piae::twin
