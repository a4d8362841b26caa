#include "spectra/power.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "spectra/fft.hpp"

namespace piae::spectra {

namespace {

using Eigen::Index;
using Complex = std::complex<double>;

/// Hann's window, and memory for a tapered window, padded with zeros, and its spectrum.
struct Workspace {
  Eigen::RowVectorXd taper;
  std::vector<double> tapered;
  std::vector<Complex> spectrum;
};

/// Returns a workspace that is made once per size and thread, because windows often come one by
/// one.
Workspace& workspace_of(Index length, Index padding) {
  thread_local std::map<std::pair<Index, Index>, Workspace> workspaces;
  Workspace& workspace = workspaces[{length, padding}];
  if (workspace.taper.size() == 0) {
    const auto padded = static_cast<std::size_t>(padding * length);
    workspace = {.taper = hann(length),
                 .tapered = std::vector<double>(padded),
                 .spectrum = std::vector<Complex>(padded / 2 + 1)};
  }
  return workspace;
}

/// Doubles the positive frequencies and removes the negative ones.
void make_analytic(std::vector<Complex>& spectrum) {
  const auto zero = spectrum.begin();
  const auto half = std::ssize(spectrum) / 2;
  const auto negative = zero + half + 1;
  std::for_each(zero + 1, negative - (std::ssize(spectrum) + 1) % 2, [](Complex& x) { x *= 2; });
  std::fill(negative, spectrum.end(), Complex(0));
}

}  // namespace

Eigen::RowVectorXd hann(Index length) {
  Eigen::RowVectorXd taper(length);
  for (Index i = 0; i < length; ++i) {
    taper[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) /
                                    static_cast<double>(length));
  }
  return taper;
}

Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Index padding) {
  const Index bins = padding * windows.cols() / 2 + 1;
  auto& [taper, tapered, spectrum] = workspace_of(windows.cols(), padding);
  Eigen::ArrayXd power = Eigen::ArrayXd::Zero(bins);
  for (Index i = 0; i < windows.rows(); ++i) {
    Eigen::Map<Eigen::RowVectorXd>(tapered.data(), windows.cols()) =
        (windows.row(i).array() - windows.row(i).mean()) * taper.array();
    fft(tapered, spectrum);
    for (Index bin = 0; bin < bins; ++bin) {
      power[bin] += std::norm(spectrum[static_cast<std::size_t>(bin)]);
    }
  }
  // Windows often come one by one.
  if (windows.rows() != 1) power /= static_cast<double>(windows.rows());
  return power;
}

Eigen::ArrayXXd spectrogram(const Eigen::Ref<const Eigen::RowVectorXd>& window,
                            Eigen::Index segment) {
  if (segment < 2 || segment % 2 != 0 || segment > window.size()) {
    throw std::logic_error("a spectrogram needs even segments that fit into the window");
  }
  const Eigen::Index hop = segment / 2;
  Eigen::ArrayXXd power((window.size() - segment) / hop + 1, hop + 1);
  for (Eigen::Index time = 0; time < power.rows(); ++time) {
    power.row(time) = mean_power_spectrum(window.segment(time * hop, segment)).transpose();
  }
  return power;
}

Windows envelopes(const Windows& windows) {
  Windows result(windows.rows(), windows.cols());
  std::vector<Complex> samples(static_cast<std::size_t>(windows.cols()));
  std::vector<Complex> spectrum(samples.size());
  for (Index i = 0; i < windows.rows(); ++i) {
    Eigen::Map<Eigen::RowVectorXcd> row(samples.data(), windows.cols());
    row = (windows.row(i).array() - windows.row(i).mean()).cast<Complex>();
    fft(samples, spectrum);
    make_analytic(spectrum);
    inverse_fft(spectrum, samples);
    // cwiseAbs would call hypot, which is slower because it guards against an overflow that cannot
    // happen here.
    result.row(i) = row.cwiseAbs2().cwiseSqrt();
  }
  return result;
}

}  // namespace piae::spectra
