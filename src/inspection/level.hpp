#pragma once

#include <span>

namespace piae::inspection {

/// Level and peakedness of a signal, about the mean, because a sensor's offset is not vibration.
struct Level {
  double rms = 0;  ///< in the signal's unit
  /// Mean fourth power over the squared mean square: 3 for normal noise, 1.5 for a sine, more with
  /// fault impacts.
  double kurtosis = 0;
  double crest_factor = 0;  ///< largest sample over RMS: the root of 2 for a sine
};

/// Returns the level of a signal, which must not be constant.
Level level_of(std::span<const double> signal);

}  // namespace piae::inspection
