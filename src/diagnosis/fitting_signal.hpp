#pragma once

#include <string>

#include "diagnosis/classifier.hpp"
#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// True if a speed is within Classifier::slowest and fastest times any speed at which faults were
/// known or generated.
bool is_fitting_speed(const Classifier& classifier, const signal::DatasetInfo& trained,
                      double shaft_speed_rpm);

/// Throws Error(bad_input), which begins with `what`, if the signal does not fit the classifier:
/// its sample rate is below that of the training (a faster signal is resampled), or its speed is
/// not a fitting one.
void require_fitting_signal(const Classifier& classifier, const signal::DatasetInfo& trained,
                            double sample_rate_hz, double shaft_speed_rpm, const std::string& what);

}  // namespace piae::diagnosis
