#pragma once

#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

double mean_of(std::span<const float> window);

/// RMS about the mean, in the signal's unit.
double rms_of(std::span<const double> signal);

/// RMS of each class's windows about their means (a sensor's offset is no vibration), in the
/// recordings' unit. 1 for a class without windows, such as the healthy one in C. Throws
/// Error(bad_input) for a class whose windows are constant.
std::vector<double> rms_by_class(const WindowSet& windows);

}  // namespace piae::signal
