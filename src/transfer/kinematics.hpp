#pragma once

#include <cstddef>

#include "signal/window_set.hpp"

namespace piae::transfer {

/// The time from strike to strike in known window i, if the shaft turned at this speed.
double period_s(const signal::WindowSet& known, std::size_t i, double rpm);

/// How long a ball would be over a defect of this size (bearing/strikes.hpp) in known window i, if
/// the shaft turned at this speed.
double passage_s(const signal::WindowSet& known, std::size_t i, double size_mm, double rpm);

/// Throws Error (bad_input) where a defect of the known windows is struck more often than every two
/// samples, at its own speed or at a tested one: no window can show a rhythm then.
void require_rhythm(const signal::WindowSet& known);

}  // namespace piae::transfer
