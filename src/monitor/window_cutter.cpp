#include "monitor/window_cutter.hpp"

#include <algorithm>

namespace piae::monitor {

void WindowCutter::add(std::span<const double> samples) {
  const std::uint64_t end = first_ + samples_.size();
  const std::uint64_t done = std::min(next_start_, end) - first_;
  samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(done));
  first_ += done;
  for (const double x : samples) samples_.push_back(static_cast<float>(x));
}

std::optional<WindowCutter::Window> WindowCutter::next() {
  if (next_start_ + length_ > first_ + samples_.size()) return std::nullopt;
  const auto at = static_cast<std::size_t>(next_start_ - first_);
  const Window window{next_start_, std::span(samples_).subspan(at, length_)};
  next_start_ += stride_;
  return window;
}

void WindowCutter::restart() {
  samples_.clear();
  first_ = 0;
  next_start_ = 0;
}

std::size_t WindowCutter::waiting() const {
  const std::uint64_t end = first_ + samples_.size();
  return static_cast<std::size_t>(end - std::min(next_start_, end));
}

}  // namespace piae::monitor
