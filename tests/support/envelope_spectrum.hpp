#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "spectra/fft.hpp"

namespace piae::bearing {

/// Amplitudes of a signal's Hilbert envelope by frequency, around the resonance of the working set
/// (1 to 3 kHz). Padding to twice the length and a Hann window keep the height of lines within 4 %.
class EnvelopeSpectrum {
 public:
  EnvelopeSpectrum(const std::vector<double>& signal, double rate_hz)
      : bin_hz_(rate_hz / static_cast<double>(2 * signal.size())) {
    std::vector<Complex> envelope = analytic(signal, rate_hz);
    const auto samples = static_cast<double>(signal.size());
    double mean = 0;
    for (Complex& x : envelope) {
      x = std::abs(x);
      mean += x.real() / samples;
    }
    for (std::size_t i = 0; i < envelope.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / samples;
      envelope[i] = (envelope[i] - mean) * (1 - std::cos(angle));
    }
    envelope.resize(2 * signal.size());
    std::vector<Complex> spectrum(envelope.size());
    spectra::fft(envelope, spectrum);
    for (std::size_t i = 0; i < signal.size(); ++i) amplitudes_.push_back(std::abs(spectrum[i]));
  }

  [[nodiscard]] double highest_line_hz(double low_hz, double high_hz) const {
    const auto highest = std::max_element(at(low_hz), at(high_hz));
    return static_cast<double>(highest - amplitudes_.begin()) * bin_hz_;
  }
  [[nodiscard]] double line(double hz) const { return *std::max_element(at(hz) - 4, at(hz) + 5); }
  [[nodiscard]] double median(double low_hz, double high_hz) const {
    std::vector<double> part(at(low_hz), at(high_hz));
    std::ranges::sort(part);
    return part[part.size() / 2];
  }

 private:
  using Complex = std::complex<double>;

  [[nodiscard]] std::vector<double>::const_iterator at(double hz) const {
    return amplitudes_.begin() + std::lround(hz / bin_hz_);
  }

  /// Returns the signal around the resonance without its negative frequencies.
  static std::vector<Complex> analytic(const std::vector<double>& signal, double rate_hz) {
    const std::vector<Complex> samples(signal.begin(), signal.end());
    std::vector<Complex> spectrum(samples.size());
    spectra::fft(samples, spectrum);
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      const double hz = static_cast<double>(i) * rate_hz / static_cast<double>(signal.size());
      if (hz < 1000 || hz > 3000) spectrum[i] = 0;  // all above rate / 2 are negative frequencies
    }
    std::vector<Complex> result(spectrum.size());
    spectra::inverse_fft(spectrum, result);
    return result;
  }

  double bin_hz_;
  std::vector<double> amplitudes_;
};

}  // namespace piae::bearing
