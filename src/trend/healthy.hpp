#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "symptoms/novelty.hpp"
#include "trend/features.hpp"
#include "trend/options.hpp"

namespace piae::trend {

/// Healthy windows as the reference of later ones.
class Healthy {
 public:
  /// Takes the features of healthy windows in order of time. Throws Error(bad_input) for fewer than
  /// symptoms::fewest_healthy windows.
  Healthy(std::vector<Features> windows, const TrendOptions& options);

  /// Returns how far the RMS lies above the healthy mean, in dB.
  [[nodiscard]] double level_rise_db(const Features& window) const {
    return window.level_db - level_db_;
  }
  /// Returns [features] how far the watched features lie above their healthy means, in dB.
  [[nodiscard]] Eigen::ArrayXd rises_db(const Features& window) const {
    return window.watched_db - mean_db_;
  }
  /// Returns [features] the largest rises of a healthy machine, in dB:
  /// max(least_rise_db, spreads * standard deviation).
  [[nodiscard]] const Eigen::ArrayXd& limits_db() const { return limits_db_; }
  /// Returns the distance of the spectrum's shape; above 1 is new (symptoms/novelty.hpp).
  [[nodiscard]] double novelty(const Features& window) const {
    return novelty_.of(window.shape_db);
  }
  [[nodiscard]] const std::vector<Features>& windows() const { return windows_; }

 private:
  std::vector<Features> windows_;
  double level_db_ = 0;
  Eigen::ArrayXd mean_db_;
  Eigen::ArrayXd limits_db_;
  symptoms::Novelty novelty_;
};

/// Writes the features of healthy windows and how they were measured, as an artefact of the kind
/// "baseline": /level_db [n], /watched_db [n, 7 or 10], /shape_db [n, 48], and as attributes of the
/// root sample_rate_hz, window_samples and, with lines, shaft_speed_rpm; then also /line_orders.
void write(artefact::Writer& writer, const FeatureMeter& meter,
           const std::vector<Features>& windows);

/// A baseline that was read.
struct Baseline {
  FeatureMeter meter;
  std::vector<Features> windows;
};
/// Reads a baseline. Throws artefact::Refusal for impossible numbers and shapes.
Baseline read_baseline(const artefact::Reader& reader);

}  // namespace piae::trend
