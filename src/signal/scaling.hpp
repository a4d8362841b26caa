#pragma once

#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

/// The samples of all windows as networks see them, row-major [n, length]: each window without its
/// mean (a sensor's offset is no vibration) and divided by its class's entry of `scale`, one for
/// each class in the unit of the recordings.
std::vector<float> scaled_windows(const WindowSet& windows, const std::vector<double>& scale);

}  // namespace piae::signal
