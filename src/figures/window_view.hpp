#pragma once

#include <Eigen/Core>

#include "figures/thinning.hpp"
#include "scoring/windows.hpp"
#include "signal/dataset_info.hpp"

namespace piae::figures {

/// Where the points of a view lie; the same for all windows of a dataset. Pictures are small, so
/// there are about a hundred points along each axis.
class ViewAxes {
 public:
  /// For windows of `length` samples, in which the shaft turns at the tested speed, or no faster
  /// than `fastest_rpm`.
  ViewAxes(const signal::DatasetInfo& info, Eigen::Index length)
      : ViewAxes(info, length, info.tested_speed_rpm()) {}
  ViewAxes(const signal::DatasetInfo& info, Eigen::Index length, double fastest_rpm);

  /// As far as the third harmonics of all fault lines reach, with their sidebands.
  static constexpr int harmonics = 3;
  /// Samples of a segment of the spectrogram: short, to show each blow of a defect.
  static constexpr Eigen::Index segment = 32;

  [[nodiscard]] double waveform_ms(Eigen::Index point) const;
  [[nodiscard]] double spectrum_hz(Eigen::Index point) const;
  [[nodiscard]] double envelope_hz(Eigen::Index point) const;
  [[nodiscard]] double spectrogram_ms(Eigen::Index time) const;
  [[nodiscard]] double spectrogram_hz(Eigen::Index bin) const;

  // What the points are made of:
  [[nodiscard]] const Thinning& samples() const { return samples_; }
  [[nodiscard]] const Thinning& bins() const { return bins_; }  ///< without the one at 0 Hz
  [[nodiscard]] const Thinning& envelope_bins() const { return envelope_bins_; }  ///< likewise
  [[nodiscard]] Eigen::Index envelope_padding() const { return envelope_padding_; }
  [[nodiscard]] Eigen::Index envelope_count() const { return envelope_count_; }

 private:
  [[nodiscard]] double bin_hz() const { return rate_hz_ / static_cast<double>(length_); }

  double rate_hz_;
  Eigen::Index length_;
  Thinning samples_;
  Thinning bins_;
  Eigen::Index envelope_padding_;  ///< how many times their length the envelopes have with zeros
  Eigen::Index envelope_count_;    ///< bins up to the last line, without the one at 0 Hz
  Thinning envelope_bins_;
};

/// What a picture shows of a set of windows. Decibels are those of amplitudes of sines, to 1 m/s^2;
/// silence has -200 dB.
struct WindowView {
  Eigen::ArrayXd low;              ///< of the window shown, m/s^2
  Eigen::ArrayXd high;             ///< likewise
  Eigen::ArrayXd spectrum_db;      ///< of all windows, the mean power
  Eigen::ArrayXd envelope_db;      ///< of the envelopes of all windows, likewise
  Eigen::ArrayXXd spectrogram_db;  ///< [times, bins] of the window shown
};

/// Which of a set of windows stands for all: the one whose RMS (about its mean) is the median, of
/// two the quieter one. What it shows best, how loud it is, is then typical. Throws
/// std::logic_error where there is none.
Eigen::Index typical_window(const scoring::Windows& windows);

/// The windows are in m/s^2. There must be one. The one that is shown is typical_window(), or
/// window `shown`.
WindowView view_of(const scoring::Windows& windows, const ViewAxes& axes);
WindowView view_of(const scoring::Windows& windows, Eigen::Index shown, const ViewAxes& axes);

}  // namespace piae::figures
