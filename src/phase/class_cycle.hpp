#pragma once

#include <cstddef>

#include "base/label.hpp"
#include "signal/cycle.hpp"
#include "signal/dataset_info.hpp"

namespace piae::phase {

/// How often the defect of a class strikes, in Hz: BPFO, BPFI, or 2 BSF for a ball, whose defect
/// strikes both races in one turn. Throws Error(bad_input) for a class without a defect.
double strike_frequency_hz(const signal::DatasetInfo& info, Label label);

/// The cycle of a class in windows of `length` samples. Throws Error(bad_input) where not one whole
/// strike fits.
signal::Cycle cycle_of_class(const signal::DatasetInfo& info, Label label, std::size_t length);

}  // namespace piae::phase
