#pragma once

#include <cstddef>
#include <cstdint>

#include "signal/made_windows.hpp"

namespace piae::transfer {

/// The known window from which a window is made, and the tested condition for which. Known windows
/// take turns, and with each round of them the tested conditions do.
struct Journey {
  std::size_t known = 0;                             ///< index of the known window in its set
  double from_rpm = 0;                               ///< the speed of the shaft in it
  std::int32_t condition = signal::every_condition;  ///< the tested one
  double to_rpm = 0;                                 ///< the speed of the shaft in that

  [[nodiscard]] double speed_ratio() const { return to_rpm / from_rpm; }
};

/// The journey of window `index` of a class. Without conditions, it leads to the speed at which it
/// started. The class must have a known window.
Journey journey_of(const signal::WindowSet& known, Label label, std::size_t index);

/// A made window that has its tested condition and speed, if the data set has conditions, and the
/// known window as its parent.
signal::MadeWindow arrived(const signal::WindowSet& known, const Journey& journey,
                           const std::vector<double>& samples);

}  // namespace piae::transfer
