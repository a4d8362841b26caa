#pragma once

#include <optional>
#include <span>

namespace piae::trend {

/// A window of the watched signal.
struct TimedWindow {
  double start_s = 0;  ///< since the start of the trend
  std::span<const float> samples;
  /// Speed of the shaft in its time; if empty, that of the meter's lines.
  std::optional<double> speed_rpm = std::nullopt;
};

}  // namespace piae::trend
