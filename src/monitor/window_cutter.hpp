#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace piae::monitor {

/// Cuts windows from a signal that arrives in pieces of any length.
class WindowCutter {
 public:
  /// `stride` is the number of samples between the starts of two windows; it may exceed `length`.
  WindowCutter(std::size_t length, std::size_t stride) : length_(length), stride_(stride) {}

  /// A window and the number of its first sample.
  struct Window {
    std::uint64_t first_sample = 0;
    std::span<const float> samples;  ///< valid until the next add()
  };

  void add(std::span<const double> samples);
  /// Returns the next complete window, if there is one.
  std::optional<Window> next();

  /// Drops the incomplete window, because the next samples do not continue it. The next sample has
  /// number 0.
  void restart();
  /// Returns the number of samples that are not part of a window yet.
  [[nodiscard]] std::size_t waiting() const;

 private:
  std::size_t length_;
  std::size_t stride_;
  std::vector<float> samples_;    ///< samples that the next windows need
  std::uint64_t first_ = 0;       ///< number of samples_[0]
  std::uint64_t next_start_ = 0;  ///< number of the next window's first sample
};

}  // namespace piae::monitor
