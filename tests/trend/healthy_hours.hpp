#pragma once

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "trend/features.hpp"

namespace piae::trend {

inline constexpr double noise_rate_hz = 1024;
inline constexpr std::size_t noise_length = 512;

/// Returns a window of white noise with this RMS.
inline std::vector<float> noise_window(Stream& random, double rms = 1) {
  std::vector<float> window(noise_length);
  for (float& x : window) x = static_cast<float>(random.normal(0, rms));
  return window;
}

/// Returns a meter of such windows, without fault lines.
inline FeatureMeter noise_meter() { return {noise_rate_hz, noise_length, std::nullopt}; }

/// Returns features with these levels in dB in all watched features but the others, which are 0.
inline Features features_of(double level_db, double first_db, double second_db) {
  Features features;
  features.level_db = level_db;
  features.watched_db = Eigen::ArrayXd::Zero(level_features);
  features.watched_db[0] = first_db;
  features.watched_db[1] = second_db;
  features.shape_db = Eigen::ArrayXd::LinSpaced(48, -1, 1) * (1 + 0.1 * first_db);
  return features;
}

}  // namespace piae::trend
