#pragma once

#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

/// Windows without their means (a sensor's offset is no vibration) and divided by their class's
/// scale, [n, N].
std::vector<float> scaled_windows(const WindowSet& windows, const std::vector<double>& scale);

}  // namespace piae::signal
