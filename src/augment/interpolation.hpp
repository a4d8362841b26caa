#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::augment {

using Window = std::span<const float>;

/// For each window the indices of its k nearest others by Euclidean distance, nearest first; of two
/// equally near ones the earlier. Throws std::logic_error when k is not below the number of windows
/// or the lengths differ.
std::vector<std::vector<std::size_t>> nearest_neighbours(const std::vector<Window>& windows,
                                                         std::size_t k);

/// base + gap (neighbour - base), a point of the line between two windows; gap in [0, 1].
std::vector<float> interpolate(Window base, Window neighbour, double gap);

}  // namespace piae::augment
