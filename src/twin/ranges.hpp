#pragma once

#include "base/range.hpp"

/// Permitted values of the numbers of a digital twin space.
namespace piae::twin::ranges {

/// k~ or c~. A network may infer a stiffness of 0.
inline constexpr Range coordinate{.low = 0, .high = 1e20};
/// Range for values of which a logarithm is taken.
inline constexpr Range positive_coordinate{.low = 1e-200, .high = 1e20};
inline constexpr Range bins{.low = 1, .high = 1000};
inline constexpr Range windows_in_a_bin{.low = 0, .high = 1e12};
inline constexpr Range open_contacts{.low = 0, .high = 1e12};

}  // namespace piae::twin::ranges
