#pragma once

#include <optional>
#include <string>

#include "spectra/shaft_speed.hpp"

namespace piae::spectra {

/// Returns a text such as "the shaft seems to turn at 1477 rpm, 5.5 % above" if the shaft certainly
/// turns at another speed than the given one, by more than 1 %; else an empty text.
std::string other_speed(const std::optional<ShaftSpeed>& shaft, double given_rpm);

}  // namespace piae::spectra
