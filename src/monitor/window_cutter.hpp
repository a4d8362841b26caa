#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace piae::monitor {

/// Cuts windows from a signal that comes in pieces, wherever these end.
class WindowCutter {
 public:
  /// `stride` samples from the start of one window to that of the next; it may exceed `length`.
  WindowCutter(std::size_t length, std::size_t stride) : length_(length), stride_(stride) {}

  /// A window, and the number of its first sample.
  struct Window {
    std::uint64_t first_sample = 0;
    std::span<const float> samples;  ///< until the next add()
  };

  void add(std::span<const double> samples);
  /// The next whole window of what was added.
  std::optional<Window> next();

  /// Forgets the begun window: what comes next does not follow what came before. Its first sample
  /// is number 0.
  void restart();
  /// Samples that no window holds yet.
  [[nodiscard]] std::size_t waiting() const;

 private:
  std::size_t length_;
  std::size_t stride_;
  std::vector<float> samples_;    ///< those that the next windows need
  std::uint64_t first_ = 0;       ///< the number of samples_[0]
  std::uint64_t next_start_ = 0;  ///< of the next window
};

}  // namespace piae::monitor
