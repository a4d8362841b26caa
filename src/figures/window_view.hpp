#pragma once

#include <Eigen/Core>

#include "figures/thinning.hpp"
#include "scoring/windows.hpp"
#include "signal/dataset_info.hpp"

namespace piae::figures {

/// Coordinates of the points of a view; the same for all windows of a data set. Pictures are small,
/// so each axis has about a hundred points.
class ViewAxes {
 public:
  /// Makes the axes for windows of `length` samples, with the shaft at the tested speed, or no
  /// faster than `fastest_rpm`.
  ViewAxes(const signal::DatasetInfo& info, Eigen::Index length)
      : ViewAxes(info, length, info.tested_speed_rpm()) {}
  ViewAxes(const signal::DatasetInfo& info, Eigen::Index length, double fastest_rpm);

  /// Number of harmonics of all fault lines that are shown, with their sidebands.
  static constexpr int harmonics = 3;
  /// Samples of a segment of the spectrogram: short, to show each impact of a defect.
  static constexpr Eigen::Index segment = 32;

  [[nodiscard]] double waveform_ms(Eigen::Index point) const;
  [[nodiscard]] double spectrum_hz(Eigen::Index point) const;
  [[nodiscard]] double envelope_hz(Eigen::Index point) const;
  [[nodiscard]] double spectrogram_ms(Eigen::Index time) const;
  [[nodiscard]] double spectrogram_hz(Eigen::Index bin) const;

  // Indices behind the points:
  [[nodiscard]] const Thinning& samples() const { return samples_; }
  [[nodiscard]] const Thinning& bins() const { return bins_; }                    ///< without 0 Hz
  [[nodiscard]] const Thinning& envelope_bins() const { return envelope_bins_; }  ///< likewise
  [[nodiscard]] Eigen::Index envelope_padding() const { return envelope_padding_; }
  [[nodiscard]] Eigen::Index envelope_count() const { return envelope_count_; }

 private:
  [[nodiscard]] double bin_hz() const { return rate_hz_ / static_cast<double>(length_); }

  double rate_hz_;
  Eigen::Index length_;
  Thinning samples_;
  Thinning bins_;
  Eigen::Index envelope_padding_;  ///< length of the padded envelopes, in window lengths
  Eigen::Index envelope_count_;    ///< bins up to the last line, without 0 Hz
  Thinning envelope_bins_;
};

/// View of a set of windows. Decibels are amplitudes of sines, relative to 1 m/s^2; silence has
/// -200 dB.
struct WindowView {
  Eigen::ArrayXd low;              ///< of the shown window, m/s^2
  Eigen::ArrayXd high;             ///< likewise
  Eigen::ArrayXd spectrum_db;      ///< of all windows, the mean power
  Eigen::ArrayXd envelope_db;      ///< of the envelopes of all windows, likewise
  Eigen::ArrayXXd spectrogram_db;  ///< [times, bins] of the shown window
};

/// Returns the index of a representative window: the one with the median RMS (about its mean), or
/// the lower of the two middle ones. Its level is then typical. Throws std::logic_error without
/// windows.
Eigen::Index typical_window(const scoring::Windows& windows);

/// Returns the view of windows in m/s^2, at least one. It shows typical_window(), or window
/// `shown`.
WindowView view_of(const scoring::Windows& windows, const ViewAxes& axes);
WindowView view_of(const scoring::Windows& windows, Eigen::Index shown, const ViewAxes& axes);

}  // namespace piae::figures
