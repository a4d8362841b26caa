#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::signal {

/// How many windows a class must give, all lengths in samples.
struct WindowGrid {
  std::size_t window;      ///< length of a window
  std::size_t max_stride;  ///< between the starts of two windows
  std::size_t windows;     ///< that play a role
  std::size_t blocks;      ///< contiguous blocks, each followed by a gap; 0 for none
  std::size_t guard;       ///< left unused in a gap, at least
};

/// Windows in a record of n samples: floor((n - window) / stride) + 1, or none.
std::size_t windows_in(std::size_t samples, std::size_t window, std::size_t stride);

/// Windows left out in a gap, so that the ones before and after it lie `guard` samples apart.
std::size_t skipped_windows(const WindowGrid& grid, std::size_t stride);

/// The largest stride up to grid.max_stride at which records of these lengths give all windows and
/// gaps. Throws Error(bad_input) that begins with `whose` and names how many windows fit at most.
std::size_t largest_stride(const std::string& whose, const std::vector<std::size_t>& lengths,
                           const WindowGrid& grid);

}  // namespace piae::signal
