#pragma once

#include <array>
#include <cstddef>

#include "symptoms/baseline.hpp"
#include "symptoms/measures.hpp"

namespace piae::symptoms {

inline constexpr std::size_t number_of_symptoms = number_of_fault_types * most_harmonics + 5;

/// Symptoms of a fault in a window. They mean the same on every machine, because they are relative
/// to the window's own floor or to healthy windows of the machine.
///   - 12: the heights of the lines, inner, ball, outer, each over 1, 2, 3 and 4 harmonics
///     (McFadden and Smith 1984; measures.hpp);
///   - the logarithm of the kurtosis, high for single impacts (Antoni 2006);
///   - the largest rise of a band's level above that of healthy windows and the mean of the three
///     largest, in dB, clipped to -3 .. 20, and the smallest, clipped to -20 .. 3;
///   - ln of the novelty (novelty.hpp), limited to 6 times the threshold.
using Symptoms = std::array<double, number_of_symptoms>;

/// Returns the symptoms. `novelty` is relative to the threshold: baseline.novelty().of(...), or
/// Baselines::left_out() for a healthy window that is in the baseline.
Symptoms symptoms_of(const Measures& window, const Baseline& baseline, double novelty);

}  // namespace piae::symptoms
