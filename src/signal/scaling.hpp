#pragma once

#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

/// Returns the samples of all windows as networks need them, row-major [n, length]. Removes each
/// window's mean, because a sensor's offset is not vibration. Divides by the entry of `scale` for
/// the window's class, in the unit of the recordings.
std::vector<float> scaled_windows(const WindowSet& windows, const std::vector<double>& scale);

}  // namespace piae::signal
