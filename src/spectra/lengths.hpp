#pragma once

#include <cstddef>
#include <stdexcept>

namespace piae::spectra {

/// Returns the length of a transform. Throws std::logic_error if the other side has `bins` bins
/// instead of `expected`.
inline std::ptrdiff_t length_of(std::size_t samples, std::size_t bins, std::size_t expected) {
  if (samples < 2 || bins != expected)
    throw std::logic_error("fft: the number of bins does not fit the number of samples");
  return static_cast<std::ptrdiff_t>(samples);
}

inline std::ptrdiff_t real_length(std::size_t samples, std::size_t bins) {
  return length_of(samples, bins, samples / 2 + 1);
}

}  // namespace piae::spectra
