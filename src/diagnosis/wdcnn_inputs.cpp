#include "diagnosis/wdcnn_inputs.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

void append_standardised(std::vector<float>& samples, const Eigen::ArrayXd& spectrum) {
  const Eigen::ArrayXf bands = spectrum.cast<float>();
  const auto begin = static_cast<std::ptrdiff_t>(samples.size());
  samples.resize(samples.size() + static_cast<std::size_t>(bands.size()));
  if (bands.minCoeff() == bands.maxCoeff()) return;  // stays zero
  standardise(std::span(bands.data(), static_cast<std::size_t>(bands.size())),
              samples.data() + begin);
}

Eigen::ArrayXd of_waveform(const scoring::Windows& window, double /*turns*/, Eigen::Index points,
                           double floor) {
  return log_spectrum(window, points, floor);
}

Eigen::ArrayXd of_envelope(const scoring::Windows& window, double /*turns*/, Eigen::Index points,
                           double floor) {
  return log_envelope_spectrum(window, points, floor);
}

}  // namespace

Eigen::Index spectral_inputs(const signal::WindowSet& windows) {
  return std::max(static_cast<Eigen::Index>(windows.length), WdcnnLayers::shortest_window);
}

LabelledWindows side_by_side(const signal::WindowSet& windows, const std::string& what,
                             const std::vector<SpectrumInput>& spectra) {
  require_varying(windows, what);
  LabelledWindows seen;
  seen.classes = windows.info.classes.size();
  seen.labels = windows.labels;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto samples = windows.window(i);
    const scoring::Windows window = Eigen::Map<const Eigen::RowVectorXf>(
                                        samples.data(), static_cast<Eigen::Index>(samples.size()))
                                        .cast<double>();
    const double floor = amplitude_floor * root_mean_square(window);
    const double duration_s = static_cast<double>(windows.length) / windows.info.sample_rate_hz;
    const double turns = windows.speed_rpm(i) / 60 * duration_s;
    for (const SpectrumInput& each : spectra) {
      append_standardised(seen.samples, each.spectrum(window, turns, each.points, floor));
    }
    if (i == 0) seen.length = seen.samples.size();
  }
  return seen;
}

LabelledWindows log_spectra(const signal::WindowSet& windows, const std::string& what) {
  return side_by_side(windows, what, {{of_waveform, spectral_inputs(windows)}});
}

LabelledWindows log_envelope_spectra(const signal::WindowSet& windows, const std::string& what) {
  return side_by_side(windows, what, {{of_envelope, spectral_inputs(windows)}});
}

LabelledWindows both_log_spectra(const signal::WindowSet& windows, const std::string& what) {
  const Eigen::Index half = spectral_inputs(windows) / 2;
  return side_by_side(windows, what, {{of_waveform, half}, {of_envelope, half}});
}

}  // namespace piae::diagnosis
