#pragma once

#include <cstddef>
#include <cstdint>

#include "signal/made_windows.hpp"

namespace piae::transfer {

/// The known window from which a window is made, and its tested condition. Known windows alternate;
/// after each round of them the tested condition changes.
struct Journey {
  std::size_t known = 0;                             ///< index of the known window in its set
  double from_rpm = 0;                               ///< shaft speed of the known window
  std::int32_t condition = signal::every_condition;  ///< the tested condition
  double to_rpm = 0;                                 ///< shaft speed of the tested condition

  [[nodiscard]] double speed_ratio() const { return to_rpm / from_rpm; }
};

/// Returns the journey of window `index` of a class. Without conditions, the speed stays the same.
/// The class must have a known window.
Journey journey_of(const signal::WindowSet& known, Label label, std::size_t index);

/// Returns a made window with the known window as its parent and, if the data set has conditions,
/// the tested condition and speed.
signal::MadeWindow arrived(const signal::WindowSet& known, const Journey& journey,
                           const std::vector<double>& samples);

}  // namespace piae::transfer
