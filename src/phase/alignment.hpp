#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::phase {

/// Where on the fault cycle a waveform begins, against a template of the same length: the shift s
/// for which template((i + s) mod L) and waveform(i) correlate most. In samples, below L.
std::size_t infer_start(std::span<const double> reference, std::span<const double> waveform);

/// Where each waveform of a class begins, against the one of them that correlates best with all
/// others. Their means must be zero; none may be silent.
struct Alignment {
  std::size_t reference = 0;        ///< which of the waveforms the others are compared with
  std::vector<std::size_t> starts;  ///< in samples of the cycle; 0 for the reference
};
Alignment align(const std::vector<std::vector<double>>& waveforms);

}  // namespace piae::phase
