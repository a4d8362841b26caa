#pragma once

#include "base/range.hpp"

/// Bounds of the numbers that describe impacts, in options and in models.
namespace piae::impacts::ranges {

inline constexpr Range part{.low = 0, .high = 1};
inline constexpr Range dispersion_ms{.low = 0, .high = 100, .unit = " ms"};
inline constexpr Range slip{.low = 0, .high = 0.2};
inline constexpr Range jitter{.low = 0, .high = 0.2};
inline constexpr Range lag_deviation{.low = 0, .high = 0.2};
inline constexpr Range extent{.low = 0.05, .high = 1000};
inline constexpr Range angle_rad{.low = 0, .high = 3.1416, .unit = " rad"};
inline constexpr Range scatter{.low = 0, .high = 10};
inline constexpr Range tilt{.low = 0, .high = 10};
inline constexpr Range size_factor{.low = 1, .high = 100};
inline constexpr Range size_mm{.low = 1e-3, .high = 1e3, .unit = " mm"};
inline constexpr Range damping_ratio{.low = 1e-4, .high = 0.7};
/// Fractions of half the sampling rate.
inline constexpr Range frequency_part{.low = 1e-3, .high = 1};
inline constexpr Range resonances{.low = 1, .high = 100};
inline constexpr Range spread_db{.low = 0, .high = 60, .unit = " dB"};
inline constexpr Range level_db{.low = -100, .high = 100, .unit = " dB"};
inline constexpr Range log_amplitude{.low = -1000, .high = 1000};
inline constexpr Range knots{.low = 2, .high = 1000};
inline constexpr Range lag_s{.low = 0, .high = 1, .unit = " s"};
inline constexpr Range exit{.low = 0, .high = 0.99};
inline constexpr Range spread{.low = 0, .high = 0.2};

}  // namespace piae::impacts::ranges
