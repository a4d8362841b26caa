#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::augment {

using Window = std::span<const float>;

/// Returns the indices of the k windows nearest to window i by Euclidean distance, nearest first
/// and without i. At equal distances the earlier window comes first. Throws std::logic_error if k
/// is not below the number of windows or the lengths differ.
std::vector<std::size_t> nearest_to(std::size_t i, const std::vector<Window>& windows,
                                    std::size_t k);

/// Returns nearest_to() of each window.
std::vector<std::vector<std::size_t>> nearest_neighbours(const std::vector<Window>& windows,
                                                         std::size_t k);

/// Returns base + gap (neighbour - base), a point on the line between two windows, for gap in [0,
/// 1].
std::vector<float> interpolate(Window base, Window neighbour, double gap);

}  // namespace piae::augment
