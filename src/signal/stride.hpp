#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::signal {

/// Number of windows that a class must give, and limits of their positions.
struct WindowGrid {
  std::size_t window;      ///< length of a window, samples
  std::size_t max_stride;  ///< most samples between the starts of two windows
  std::size_t windows;     ///< number of windows assigned to roles
  std::size_t blocks;      ///< contiguous blocks, each followed by a gap; 0 without blocks
  std::size_t guard;       ///< fewest samples left unused in a gap
};

/// Returns the windows in a record of n samples: floor((n - window) / stride) + 1, or 0.
std::size_t windows_in(std::size_t samples, std::size_t window, std::size_t stride);

/// Returns the number of windows to skip in a gap, so that its neighbours lie at least `guard`
/// samples apart.
std::size_t skipped_windows(const WindowGrid& grid, std::size_t stride);

/// Returns the largest stride up to grid.max_stride at which records of these lengths give all
/// windows and gaps. Throws Error(bad_input) if none does; the message starts with `whose` and
/// gives the largest number of windows that fit.
std::size_t largest_stride(const std::string& whose, const std::vector<std::size_t>& lengths,
                           const WindowGrid& grid);

}  // namespace piae::signal
