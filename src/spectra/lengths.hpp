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

/// Returns the largest length up to `most` with a fast Fourier transform: without prime factors
/// above 5.
inline std::size_t fast_length(std::size_t most) {
  for (std::size_t length = most;; --length) {
    std::size_t rest = length;
    for (const std::size_t prime : {2U, 3U, 5U}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return length;
  }
}

}  // namespace piae::spectra
