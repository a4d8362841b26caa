#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/catalogue.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Composes the training set of one ratio (paper, 4.3.2): all of B (healthy windows), all of C (the
/// known windows of every fault class, or none), and the first `generated_per_class` windows of
/// every fault class of E, in this order. Each window has its shaft speed. If E has none, it is the
/// common speed of B, C and all conditions (symptoms/baseline.hpp); if these differ, that of the
/// known windows that a window was made from (its parents, or all of its class if E does not store
/// any), because methods that change the speed store it; NaN if these differ, too, or are not
/// known. `generated` is null without E. Throws Error(usage) if E is missing though needed, or
/// given though unused. Throws Error(bad_input) if the sets differ in data set or window length, if
/// B or C lacks a class or has a wrong one, and if E has too few windows of a class.
signal::WindowSet compose_training_set(const signal::WindowSet& normal,
                                       const signal::WindowSet& known,
                                       const signal::WindowSet* generated,
                                       std::int64_t generated_per_class);

/// Returns the indices of the first `per_class` windows of each fault class in E, class by class.
std::vector<std::size_t> first_of_each_fault(const signal::WindowSet& generated,
                                             std::size_t per_class);

/// Throws Error(bad_input), which names the file of C, if the training set has no fault window and
/// the classifier is not a rule.
void require_faults(const signal::WindowSet& training, const Classifier& classifier,
                    const std::string& known_file);

/// Throws Error(bad_input) if the test set is of another data set or window length than the
/// training set, or lacks a class.
void require_fitting_test_set(const signal::WindowSet& test, const signal::WindowSet& training);

}  // namespace piae::diagnosis
