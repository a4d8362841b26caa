#pragma once

#include <cstddef>

#include "signal/window_set.hpp"
#include "spectra/power.hpp"

namespace piae::scoring {

using spectra::Windows;

/// Returns the first `count` windows of a class, in their stored order. Throws std::logic_error if
/// there are fewer.
Windows windows_of(const signal::WindowSet& set, Label label, std::size_t count);

}  // namespace piae::scoring
