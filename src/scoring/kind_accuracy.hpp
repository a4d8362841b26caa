#pragma once

#include <span>

#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// Share of windows whose kind was recognised, in [0, 1]: healthy, or which part of the bearing is
/// damaged (signal::Defect). A class that is taken for another of the same defect, such as one of
/// another size, counts as right; so this is never less than accuracy(). What a maintainer asks
/// first. `classes` are those of the confusion matrix. Throws std::logic_error when there is not
/// one window, and for another number of classes.
double kind_accuracy(const Confusion& confusion, std::span<const signal::ClassInfo> classes);

}  // namespace piae::scoring
