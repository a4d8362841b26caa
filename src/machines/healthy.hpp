#pragma once

#include <cstddef>

#include "base/random.hpp"
#include "machines/machine.hpp"
#include "signal/window_set.hpp"

namespace piae::machines {

/// Day of a healthy recording: that of the reference, or another one, with a path of its own.
enum class Day { of_reference, other };

/// Simulates healthy windows of a machine: noise with the spectrum and the modulation of the
/// machine, stray impacts, tones and sensor noise. Gains of the path differ from window to window.
signal::WindowSet healthy_windows(const Machine& machine, std::size_t count, Day day,
                                  const Stream& stream);

}  // namespace piae::machines
