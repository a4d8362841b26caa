#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/catalogue.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Composes the training set of one ratio (paper, 4.3.2): all of B (healthy windows), all of C (the
/// known windows of every fault class, or none at all), and of E the first `generated_per_class`
/// windows of every fault class, in this order. Each says the speed of the shaft in it. Where E is
/// silent, that is the one of B, C and all conditions (symptoms/baseline.hpp), and NaN where these
/// have several. `generated` is null where there is no E. Throws Error(usage) when E is missing
/// though it is needed, or given though none of it would be used; Error(bad_input) when the sets
/// are of different datasets or window lengths, when B or C lacks a class or holds one that does
/// not belong there, and when E has too few windows of a class.
signal::WindowSet compose_training_set(const signal::WindowSet& normal,
                                       const signal::WindowSet& known,
                                       const signal::WindowSet* generated,
                                       std::int64_t generated_per_class);

/// Which windows of E these are: of each fault class the first ones, class by class.
std::vector<std::size_t> first_of_each_fault(const signal::WindowSet& generated,
                                             std::size_t per_class);

/// Throws Error(bad_input), which names the file of C, where the training set has no fault window
/// and the classifier is not a rule.
void require_faults(const signal::WindowSet& training, const Classifier& classifier,
                    const std::string& known_file);

/// Throws Error(bad_input) when the test set is of another dataset or window length than the
/// training set, or lacks a class.
void require_fitting_test_set(const signal::WindowSet& test, const signal::WindowSet& training);

}  // namespace piae::diagnosis
