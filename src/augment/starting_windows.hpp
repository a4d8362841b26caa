#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::augment {

/// Returns for each known window how many of its nearest real windows, the known and the healthy
/// ones, belong to another class. `among` is the number of nearest windows. At equal distances
/// known windows come first. Throws Error(usage) if fewer other real windows exist.
std::vector<std::int64_t> foreign_neighbours(const signal::WindowSet& known,
                                             const signal::WindowSet& healthy, int among);

/// Returns the starting points of the first `count` generated windows: at each turn the window that
/// lags most behind its part of the weights; at equal lags the earlier one. After each multiple of
/// the sum of the weights, all have exactly their part. Equal weights give 0, 1, ..., n - 1, 0, ...
/// Weights must not be negative, and one must be positive.
std::vector<std::size_t> even_turns(std::span<const std::int64_t> weights, std::size_t count);

}  // namespace piae::augment
