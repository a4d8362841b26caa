#pragma once

#include <span>
#include <string>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::signal {

/// Mean of the samples, in the signal's unit.
double mean_of(std::span<const float> window);

/// RMS about the mean, in the signal's unit.
double rms_of(std::span<const double> signal);

/// Whether nothing moves in a window: its samples are all the same.
bool is_constant(std::span<const float> window);

/// For each class, by label, the RMS of its windows, each about its own mean (a sensor's offset is
/// no vibration), in the unit of the recordings. A class without windows, such as the healthy one
/// in C, has 1. Throws Error(bad_input) for a class whose windows are constant.
std::vector<double> rms_by_class(const WindowSet& windows);

/// The same with the largest absolute value about each window's own mean.
std::vector<double> peak_by_class(const WindowSet& windows);

/// Reads what a model stores of these, a number for each class.
std::vector<double> read_amplitudes(const artefact::Reader& reader, const std::string& path,
                                    const DatasetInfo& info);

}  // namespace piae::signal
