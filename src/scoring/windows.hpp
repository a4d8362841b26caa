#pragma once

#include <cstddef>

#include "signal/window_set.hpp"
#include "spectra/power.hpp"

namespace piae::scoring {

using spectra::Windows;

/// The first `count` windows of a class, in the order in which they are stored. Throws
/// std::logic_error when there are fewer.
Windows windows_of(const signal::WindowSet& set, Label label, std::size_t count);

}  // namespace piae::scoring
