#include "impacts/response.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "spectra/fft.hpp"
#include "spectra/power.hpp"

namespace piae::impacts {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

constexpr double fall_part = 0.3;
constexpr Index steps = 4;    ///< steps of a quarter of a piece, from the first piece to the last
constexpr Index padding = 4;  ///< from half a window to a frame of two windows

/// Returns pieces of half a window, one per row.
spectra::Windows pieces_of(const signal::WindowSet& windows, std::span<const std::size_t> own) {
  const auto length = static_cast<Index>((windows.length + 1) / 2);
  const Index step = (static_cast<Index>(windows.length) - length) / steps;
  const Index in_a_window = steps + 1;
  spectra::Windows pieces(static_cast<Index>(own.size()) * in_a_window, length);
  Index row = 0;
  for (const std::size_t i : own) {
    const Eigen::Map<const Eigen::RowVectorXf> window(windows.window(i).data(),
                                                      static_cast<Index>(windows.length));
    for (Index j = 0; j < in_a_window; ++j) {
      pieces.row(row++) = window.segment(j * step, length).cast<double>();
    }
  }
  return pieces;
}

ArrayXcd spectrum_of(const ArrayXd& samples) {
  ArrayXcd spectrum(samples.size() / 2 + 1);
  spectra::fft({samples.data(), samples.data() + samples.size()},
               {spectrum.data(), spectrum.data() + spectrum.size()});
  return spectrum;
}

}  // namespace

ArrayXd samples_of(const ArrayXcd& spectrum) {
  ArrayXd samples(2 * (spectrum.size() - 1));
  spectra::inverse_fft({spectrum.data(), spectrum.data() + spectrum.size()},
                       {samples.data(), samples.data() + samples.size()});
  return samples;
}

ArrayXd liftered(const ArrayXd& log_amplitude, double quefrency) {
  ArrayXd cepstrum = samples_of(log_amplitude.cast<std::complex<double>>());
  for (Index i = 0; i < cepstrum.size(); ++i) {
    const auto place = static_cast<double>(std::min(i, cepstrum.size() - i));
    cepstrum[i] *= std::clamp((quefrency - place) / (fall_part * quefrency), 0.0, 1.0);
  }
  return spectrum_of(cepstrum).real();
}

ArrayXcd minimum_phase(const ArrayXd& log_amplitude) {
  ArrayXd cepstrum = samples_of(log_amplitude.cast<std::complex<double>>());
  const Index half = cepstrum.size() / 2;
  cepstrum.segment(1, half - 1) *= 2;
  cepstrum.tail(half - 1) = 0;
  return spectrum_of(cepstrum).exp();
}

void filter(std::span<double> window, std::span<const std::complex<double>> gains) {
  if (gains.size() != window.size() / 2 + 1) {
    throw std::logic_error("filter: the spectrum needs one gain for each bin");
  }
  std::vector<double> samples(window.begin(), window.end());
  std::vector<std::complex<double>> spectrum(gains.size());
  spectra::fft(samples, spectrum);
  for (std::size_t i = 0; i < gains.size(); ++i) spectrum[i] *= gains[i];
  spectra::inverse_fft(spectrum, samples);
  std::ranges::copy(samples, window.begin());
}

std::vector<std::size_t> windows_in(const signal::WindowSet& windows, std::int32_t condition) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const bool in_every =
        windows.condition.empty() || windows.condition[i] == signal::every_condition;
    if (in_every || windows.condition[i] == condition) own.push_back(i);
  }
  return own;
}

ArrayXd log_amplitude(const signal::WindowSet& windows, std::span<const std::size_t> own) {
  const ArrayXd power = spectra::mean_power_spectrum(pieces_of(windows, own), padding);
  const double silence = std::numeric_limits<double>::min();
  return (power + silence).log() / 2;
}

}  // namespace piae::impacts
