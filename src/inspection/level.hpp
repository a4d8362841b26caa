#pragma once

#include <span>

namespace piae::inspection {

/// How strong and how peaked a signal is. All three are about the mean, since a sensor's offset is
/// no vibration.
struct Level {
  double rms = 0;  ///< in the signal's unit
  /// The mean fourth power over the square of the mean square: 3 for normal noise, 1.5 for a sine,
  /// more where a fault strikes.
  double kurtosis = 0;
  double crest_factor = 0;  ///< the greatest sample over the RMS: the root of 2 for a sine
};

/// The signal must not be constant.
Level level_of(std::span<const double> signal);

}  // namespace piae::inspection
