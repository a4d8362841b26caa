#pragma once

#include <array>

namespace piae::spectra {

/// Frequencies of the mains. Their harmonics show in recordings as hum, and are not vibration.
inline constexpr std::array mains_hz{50.0, 60.0};

}  // namespace piae::spectra
