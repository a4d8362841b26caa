#pragma once

#include <span>
#include <string>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

/// Returns the mean of the samples, in the signal's unit.
double mean_of(std::span<const float> window);

/// Returns the RMS about the mean, in the signal's unit.
double rms_of(std::span<const double> signal);

/// True if all samples of a window are equal.
bool is_constant(std::span<const float> window);

/// Returns for each class, by label, the RMS of its windows in the unit of the recordings. Removes
/// each window's mean, because a sensor's offset is not vibration. A class without windows, such as
/// the healthy class in C, has 1. Throws Error(bad_input) for a class with constant windows.
std::vector<double> rms_by_class(const WindowSet& windows);

/// Returns the largest absolute value instead of the RMS, about each window's own mean.
std::vector<double> peak_by_class(const WindowSet& windows);

/// Reads the amplitudes that a model stores, one for each class.
std::vector<double> read_amplitudes(const artefact::Reader& reader, const std::string& path,
                                    const DatasetInfo& info);

}  // namespace piae::signal
