#pragma once

#include "base/range.hpp"

/// Permitted settings of a diffusion or flow model.
namespace piae::diffusion::ranges {

inline constexpr Range steps{.low = 1, .high = 1000};
inline constexpr Range guidance{.low = 0, .high = 100};

}  // namespace piae::diffusion::ranges
