#pragma once

#include "base/range.hpp"

/// What the sizes of a stored network may be. That its parameters have these shapes, reading them
/// shows; nothing may be made by a size before that.
namespace piae::nets::ranges {

inline constexpr Range depth{.low = 1, .high = 32, .unit = " layers"};
inline constexpr Range width{.low = 1, .high = 1 << 20, .unit = " units"};
inline constexpr Range latent{.low = 1, .high = 1 << 20, .unit = " numbers"};

}  // namespace piae::nets::ranges
