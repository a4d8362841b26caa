#pragma once

#include <cstddef>
#include <cstdint>

#include "signal/window_set.hpp"

namespace piae::transfer {

/// From which known window a window is made, and for which tested condition. Known windows take
/// turns, and with each round of them the tested conditions do.
struct Journey {
  std::size_t known = 0;                             ///< index of the known window in its set
  double from_rpm = 0;                               ///< the speed of the shaft in it
  std::int32_t condition = signal::every_condition;  ///< the tested one
  double to_rpm = 0;                                 ///< the speed of the shaft in that

  [[nodiscard]] double speed_ratio() const { return to_rpm / from_rpm; }
};

/// The journey of window `index` of a class. Without conditions, it leads to the speed at which it
/// began. The class must have a known window.
Journey journey_of(const signal::WindowSet& known, Label label, std::size_t index);

/// Says of made windows, `count` of each class with a defect, in which condition they are.
void arrive(const signal::WindowSet& known, std::size_t count, signal::WindowSet& made);

}  // namespace piae::transfer
