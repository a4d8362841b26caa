#pragma once

#include "base/range.hpp"

/// Permitted sizes of a stored network. Do not allocate by these sizes before reading the
/// parameters, whose shapes confirm them.
namespace piae::nets::ranges {

inline constexpr Range depth{.low = 1, .high = 32, .unit = " layers"};
inline constexpr Range width{.low = 1, .high = 1 << 20, .unit = " units"};
inline constexpr Range latent{.low = 1, .high = 1 << 20, .unit = " numbers"};

}  // namespace piae::nets::ranges
