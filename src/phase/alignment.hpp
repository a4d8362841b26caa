#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::phase {

/// Returns where on the fault cycle a waveform begins, compared with a reference of the same length
/// L: the shift s, from 0 to L - 1 samples, for which reference((i + s) mod L) and waveform(i)
/// correlate most.
std::size_t infer_start(std::span<const double> reference, std::span<const double> waveform);

/// Starts of a class's waveforms on the fault cycle.
struct Alignment {
  std::size_t reference = 0;        ///< index of the waveform that the others are compared with
  std::vector<std::size_t> starts;  ///< in samples of the cycle; 0 for the reference
};

/// Aligns the waveforms of a class with the waveform that correlates best with all others. All must
/// have equal lengths and the mean 0, and none may be silent.
Alignment align(const std::vector<std::vector<double>>& waveforms);

}  // namespace piae::phase
