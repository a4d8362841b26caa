#pragma once

#include "base/range.hpp"

/// What the numbers of windows that are made without a known fault may be.
namespace piae::zero::ranges {

inline constexpr Range part{.low = 0, .high = 1};
inline constexpr Range slip{.low = 0, .high = 0.2};
inline constexpr Range jitter{.low = 0, .high = 0.2};
inline constexpr Range extent{.low = 0.05, .high = 1000};
inline constexpr Range angle_rad{.low = 0, .high = 3.1416, .unit = " rad"};
inline constexpr Range scatter{.low = 0, .high = 10};
inline constexpr Range size_mm{.low = 1e-3, .high = 1e3, .unit = " mm"};
inline constexpr Range damping_ratio{.low = 1e-4, .high = 0.7};
/// Of half the sampling rate.
inline constexpr Range frequency_part{.low = 1e-3, .high = 1};
inline constexpr Range resonances{.low = 1, .high = 100};
inline constexpr Range spread_db{.low = 0, .high = 60, .unit = " dB"};
inline constexpr Range level_db{.low = -100, .high = 100, .unit = " dB"};

}  // namespace piae::zero::ranges
