#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::signal {

/// How many windows a class must give, and how they may lie.
struct WindowGrid {
  std::size_t window;      ///< length of a window, samples
  std::size_t max_stride;  ///< the most samples between the starts of two windows
  std::size_t windows;     ///< how many are dealt out to the roles
  std::size_t blocks;      ///< how many contiguous blocks, each followed by a gap; 0 for none
  std::size_t guard;       ///< the fewest samples left unused in a gap
};

/// How many windows a record of n samples gives: floor((n - window) / stride) + 1, or none.
std::size_t windows_in(std::size_t samples, std::size_t window, std::size_t stride);

/// How many windows are left out in a gap, so that those before and after it lie at least `guard`
/// samples apart.
std::size_t skipped_windows(const WindowGrid& grid, std::size_t stride);

/// The largest stride up to grid.max_stride at which records of these lengths give all windows and
/// gaps. Throws Error(bad_input) where there is none; the line begins with `whose` and says how
/// many windows fit at most.
std::size_t largest_stride(const std::string& whose, const std::vector<std::size_t>& lengths,
                           const WindowGrid& grid);

}  // namespace piae::signal
