#pragma once

#include <cstddef>

#include "base/label.hpp"
#include "signal/cycle.hpp"
#include "signal/dataset_info.hpp"

namespace piae::phase {

/// Returns the impact rate of a class's defect, in Hz: BPFO, BPFI, or 2 BSF for a ball, whose
/// defect hits both races in one turn. Throws Error(bad_input) for a class without a defect.
double impact_frequency_hz(const signal::DatasetInfo& info, Label label);

/// Returns the cycle of a class in windows of `length` samples. Throws Error(bad_input) if not one
/// whole period between impacts fits.
signal::Cycle cycle_of_class(const signal::DatasetInfo& info, Label label, std::size_t length);

}  // namespace piae::phase
