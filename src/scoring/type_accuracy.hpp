#pragma once

#include <span>

#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// Returns the share of windows whose fault type was recognised, in [0, 1]: healthy, or the damaged
/// part of the bearing (signal::Defect). Another class of the same fault type, such as another
/// size, counts as correct, so the result is never below accuracy(). Maintenance asks for the fault
/// type first. `classes` are those of the confusion matrix. Throws std::logic_error without
/// windows, and for another number of classes.
double type_accuracy(const Confusion& confusion, std::span<const signal::ClassInfo> classes);

}  // namespace piae::scoring
