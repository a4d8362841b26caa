#include "figures/window_view.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "bearing/kinematics.hpp"
#include "spectra/power.hpp"

namespace piae::figures {

namespace {

using Eigen::Index;

constexpr Index most_points = 128;  // of a curve
constexpr Index most_padding = 16;
constexpr double silence = 1e-20;  // as power

/// Returns the frequency at which the envelope spectrum ends.
double last_line_hz(const signal::DatasetInfo& info, double fastest_rpm) {
  constexpr double shown_turns = 20;  // used without fault lines
  if (!info.has_bearing) return shown_turns * fastest_rpm / 60;
  const auto f = bearing::fault_frequencies(info.bearing, fastest_rpm);
  return ViewAxes::harmonics * std::max({f.bpfo_hz, f.bpfi_hz, 2 * f.bsf_hz}) + 2 * f.shaft_hz;
}

/// Returns a zero padding that gives enough points for the lines of slow shafts, too.
Index padding_for(double last_hz, double bin_hz) {
  Index padding = 2;
  while (padding < most_padding &&
         2 * static_cast<double>(padding) * last_hz / bin_hz <= most_points) {
    padding *= 2;
  }
  return padding;
}

/// Converts powers under Hann's window to the level of a sine with the same power.
Eigen::ArrayXXd level_db(const Eigen::ArrayXXd& power, Index length) {
  const double of_unit_sine = static_cast<double>(length * length) / 16;
  return 10 * (power / of_unit_sine).max(silence).log10();
}

}  // namespace

ViewAxes::ViewAxes(const signal::DatasetInfo& info, Index length, double fastest_rpm)
    : rate_hz_(info.sample_rate_hz),
      length_(length),
      samples_(length, most_points),
      bins_(length / 2, most_points),
      envelope_padding_(padding_for(last_line_hz(info, fastest_rpm), bin_hz())),
      envelope_count_(std::min(envelope_padding_ * length / 2,
                               std::lround(static_cast<double>(envelope_padding_) *
                                           last_line_hz(info, fastest_rpm) / bin_hz()))),
      envelope_bins_(envelope_count_, most_points) {}

double ViewAxes::waveform_ms(Index point) const { return 1e3 * samples_.middle(point) / rate_hz_; }

double ViewAxes::spectrum_hz(Index point) const { return (1 + bins_.middle(point)) * bin_hz(); }

double ViewAxes::envelope_hz(Index point) const {
  return (1 + envelope_bins_.middle(point)) * bin_hz() / static_cast<double>(envelope_padding_);
}

double ViewAxes::spectrogram_ms(Index time) const {
  constexpr Index step = segment / 2;
  return 1e3 * static_cast<double>((time + 1) * step) / rate_hz_;
}

double ViewAxes::spectrogram_hz(Index bin) const {
  return static_cast<double>(bin) * rate_hz_ / static_cast<double>(segment);
}

Index typical_window(const scoring::Windows& windows) {
  if (windows.rows() == 0) throw std::logic_error("no windows have none that is typical");
  // A variable of its own, because within the expression all means would be recomputed for each
  // row.
  const Eigen::VectorXd means = windows.rowwise().mean();
  const Eigen::ArrayXd squares = (windows.colwise() - means).rowwise().squaredNorm();
  std::vector<Index> by_level(static_cast<std::size_t>(windows.rows()));
  std::iota(by_level.begin(), by_level.end(), Index{0});
  std::ranges::stable_sort(by_level, {}, [&](Index i) { return squares[i]; });
  return by_level[(by_level.size() - 1) / 2];
}

WindowView view_of(const scoring::Windows& windows, const ViewAxes& axes) {
  return view_of(windows, typical_window(windows), axes);
}

WindowView view_of(const scoring::Windows& windows, Index shown, const ViewAxes& axes) {
  const Eigen::RowVectorXd samples = windows.row(shown);
  const Index length = windows.cols();
  const Eigen::ArrayXd spectrum = spectra::mean_power_spectrum(windows);
  const Eigen::ArrayXd envelope =
      spectra::mean_power_spectrum(spectra::envelopes(windows), axes.envelope_padding());
  return {.low = axes.samples().lowest(samples.transpose()),
          .high = axes.samples().highest(samples.transpose()),
          .spectrum_db = level_db(axes.bins().highest(spectrum.tail(length / 2)), length),
          .envelope_db = level_db(
              axes.envelope_bins().highest(envelope.segment(1, axes.envelope_count())), length),
          .spectrogram_db =
              level_db(spectra::spectrogram(samples, ViewAxes::segment), ViewAxes::segment)};
}

}  // namespace piae::figures
