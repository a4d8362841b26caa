#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bearing/geometry.hpp"
#include "spectra/bands.hpp"
#include "symptoms/measures.hpp"
#include "trend/octave_bands.hpp"

namespace piae::trend {

/// Orders of a bearing's fault lines and the speed of its shaft.
struct Lines {
  std::array<double, symptoms::number_of_fault_types> orders{};  ///< symptoms::line_orders()
  double speed_rpm = 0;
};

/// Returns the lines of a bearing that windows of this length and rate can separate. Returns none
/// if they cannot: the lines lie too close together, or beyond half the sample rate.
std::optional<Lines> lines_shown(const bearing::Geometry& bearing, double speed_rpm, double rate_hz,
                                 std::size_t length);

/// Number of watched features that are levels: octaves and peak. Lines follow.
inline constexpr std::size_t level_features = octaves + 1;

/// Measures of one window.
struct Features {
  double level_db = 0;  ///< of the RMS in the watched frequencies, over one unit of the signal
  /// [7] mean power in six octaves (octave_bands.hpp) and peak in all of them, in dB. With lines
  /// [10]: also the height of the lines of inner race, ball and outer race over four harmonics
  /// (spectra::common_slip_height()), in dB.
  Eigen::ArrayXd watched_db;
  Eigen::ArrayXd shape_db;  ///< [48] of the spectrum (spectra/bands.hpp)
};

/// Measures windows of one length and sample rate.
class FeatureMeter {
 public:
  FeatureMeter(double rate_hz, std::size_t length, const std::optional<Lines>& lines);

  /// Returns the measures of a window that is not constant, with lines at this speed, or else at
  /// that of lines(). Throws Error(bad_input) for a window of fewer than 256 samples.
  [[nodiscard]] Features measure(std::span<const float> window,
                                 std::optional<double> speed_rpm = std::nullopt) const;

  [[nodiscard]] double rate_hz() const { return rate_hz_; }
  [[nodiscard]] std::size_t length() const { return length_; }
  [[nodiscard]] double window_s() const { return static_cast<double>(length_) / rate_hz_; }
  [[nodiscard]] const std::optional<Lines>& lines() const { return lines_; }
  /// Returns the names of the watched features: "400-800 Hz", "peak", "outer line".
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  [[nodiscard]] Eigen::ArrayXd line_heights_db(const Eigen::RowVectorXd& window,
                                               double speed_rpm) const;

  double rate_hz_;
  std::size_t length_;
  std::optional<Lines> lines_;
  spectra::FilterBank bank_;
};

}  // namespace piae::trend
