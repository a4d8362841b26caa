#include "signal/stride.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace piae::signal {

namespace {

/// Returns the number of windows left for the roles after the gaps.
std::size_t usable_windows(const std::vector<std::size_t>& lengths, const WindowGrid& grid,
                           std::size_t stride) {
  std::size_t all = 0;
  for (const std::size_t length : lengths) all += windows_in(length, grid.window, stride);
  const std::size_t gaps = grid.blocks * skipped_windows(grid, stride);
  return all > gaps ? all - gaps : 0;
}

/// Returns the first stride to try. A stride beyond the longest record gives the same windows as
/// that length.
std::size_t first_stride(const std::vector<std::size_t>& lengths, const WindowGrid& grid) {
  std::size_t longest = 1;
  for (const std::size_t length : lengths) longest = std::max(longest, length);
  return std::min(grid.max_stride, longest);
}

[[noreturn]] void refuse(const std::string& whose, const std::vector<std::size_t>& lengths,
                         const WindowGrid& grid) {
  std::size_t most = 0;
  std::size_t at_stride = 1;
  for (std::size_t stride = first_stride(lengths, grid); stride >= 1; --stride) {
    const std::size_t usable = usable_windows(lengths, grid, stride);
    if (usable <= most) continue;
    most = usable;
    at_stride = stride;
  }
  std::size_t samples = 0;
  for (const std::size_t length : lengths) samples += length;
  const std::string cure = most == 0
                               ? "none fits: lower window or (protocol blocked) guard-windows, in "
                                 "[split] of the description, or give longer recordings"
                               : "at most " + std::to_string(most) + " fit, at stride " +
                                     std::to_string(at_stride) +
                                     ": lower windows-per-class (and test-per-class) or window, in "
                                     "[split] of the description or as options of split";
  throw Error(Exit::bad_input, whose + ": " + std::to_string(grid.windows) + " windows of " +
                                   std::to_string(grid.window) + " samples do not fit into " +
                                   std::to_string(samples) + " samples in " +
                                   std::to_string(lengths.size()) +
                                   " record(s) at any stride up to " +
                                   std::to_string(grid.max_stride) + "; " + cure);
}

}  // namespace

std::size_t windows_in(std::size_t samples, std::size_t window, std::size_t stride) {
  return samples < window ? 0 : (samples - window) / stride + 1;
}

std::size_t skipped_windows(const WindowGrid& grid, std::size_t stride) {
  const std::size_t apart = grid.window + grid.guard;  // smallest distance of two starts
  return (apart + stride - 1) / stride - 1;
}

std::size_t largest_stride(const std::string& whose, const std::vector<std::size_t>& lengths,
                           const WindowGrid& grid) {
  for (std::size_t stride = first_stride(lengths, grid); stride >= 1; --stride) {
    if (usable_windows(lengths, grid, stride) >= grid.windows) return stride;
  }
  refuse(whose, lengths, grid);
}

}  // namespace piae::signal
