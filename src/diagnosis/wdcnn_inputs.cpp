#include "diagnosis/wdcnn_inputs.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

/// A spectrum of a window in which the shaft makes `turns`, with at least the given number of
/// bands.
using Spectrum = Eigen::ArrayXd (*)(const scoring::Windows& window, double turns,
                                    Eigen::Index least_bands, double floor);

Eigen::ArrayXd of_waveform(const scoring::Windows& window, double /*turns*/,
                           Eigen::Index least_bands, double floor) {
  return log_spectrum(window, least_bands, floor);
}

Eigen::ArrayXd of_envelope(const scoring::Windows& window, double /*turns*/,
                           Eigen::Index least_bands, double floor) {
  return log_envelope_spectrum(window, least_bands, floor);
}

void append_standardised(std::vector<float>& samples, const Eigen::ArrayXd& spectrum) {
  const Eigen::ArrayXf bands = spectrum.cast<float>();
  const auto begin = static_cast<std::ptrdiff_t>(samples.size());
  samples.resize(samples.size() + static_cast<std::size_t>(bands.size()));
  if (bands.minCoeff() == bands.maxCoeff()) return;  // stays zero
  standardise(std::span(bands.data(), static_cast<std::size_t>(bands.size())),
              samples.data() + begin);
}

/// Returns the given spectra of each window one after another, all with the same number of bands.
LabelledWindows represent(const signal::WindowSet& windows, const std::string& what,
                          std::initializer_list<Spectrum> spectra) {
  require_varying(windows, what);
  const auto inputs =
      std::max(static_cast<Eigen::Index>(windows.length), WdcnnLayers::shortest_window);
  LabelledWindows seen;
  seen.classes = windows.info.classes.size();
  seen.labels = windows.labels;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto samples = windows.window(i);
    const scoring::Windows window = Eigen::Map<const Eigen::RowVectorXf>(
                                        samples.data(), static_cast<Eigen::Index>(samples.size()))
                                        .cast<double>();
    const double floor = amplitude_floor * root_mean_square(window);
    for (const Spectrum spectrum : spectra) {
      append_standardised(seen.samples,
                          spectrum(window, shaft_turns(windows, i),
                                   inputs / static_cast<Eigen::Index>(spectra.size()), floor));
    }
    if (i == 0) seen.length = seen.samples.size();
  }
  return seen;
}

}  // namespace

LabelledWindows log_spectra(const signal::WindowSet& windows, const std::string& what) {
  return represent(windows, what, {of_waveform});
}

LabelledWindows log_envelope_spectra(const signal::WindowSet& windows, const std::string& what) {
  return represent(windows, what, {of_envelope});
}

LabelledWindows both_log_spectra(const signal::WindowSet& windows, const std::string& what) {
  return represent(windows, what, {of_waveform, of_envelope});
}

LabelledWindows spectra_by_order(const signal::WindowSet& windows, const std::string& what) {
  require_speeds(windows, "a spectrum over orders");
  return represent(windows, what, {of_waveform, log_order_spectrum});
}

}  // namespace piae::diagnosis
