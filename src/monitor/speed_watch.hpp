#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spectra/shaft_speed.hpp"

namespace piae::monitor {

/// Speed of the shaft of a stream, as it is known beforehand, and how it is searched.
struct SpeedSearch {
  double given_rpm = 0;  ///< 0: unknown, and nothing is searched
  /// Range about the given speed in which it is taken from the stream; 0: the given speed counts.
  double percent = 0;
  /// True if windows of this speed can be judged; if empty, any can.
  std::function<bool(double rpm)> fits = {};
  /// Receives a line when the shaft turns at another speed than the given one, by more than 1 %,
  /// and each time that changes by more than 1 %.
  std::function<void(const std::string&)> say = {};
};

/// Estimates the speed of the shaft while a stream runs (spectra/shaft_speed.hpp), in blocks of
/// 10 s or 100 turns, whichever is more, but at most 2^19 samples. One block of noise in 100 seems
/// to show a speed, and a stream has thousands. So a speed counts once two successive blocks show
/// it within 0.5 %, and until two others show another one. If it is not taken from the stream, only
/// the first six blocks are searched. The results do not depend on how the stream was cut into
/// pieces.
class SpeedWatch {
 public:
  /// `stream` is the name in messages.
  SpeedWatch(double rate_hz, SpeedSearch search, std::string stream);

  void add(std::span<const double> samples);
  /// Drops the incomplete block after a gap. The next sample comes at this time of the stream.
  void restart(double next_s);
  /// Returns the speed of a window that ends at this time, which has passed: the last one that the
  /// stream showed before, or the given one. Later calls must be for later windows.
  double rpm_at(double end_s);

 private:
  void finish_block();
  void take(double rpm);
  void report(double rpm, bool is_used);

  double rate_hz_;
  SpeedSearch search_;
  std::string stream_;
  std::size_t block_;
  double start_s_ = 0;  ///< stream time of the block's first sample
  std::size_t blocks_ = 0;
  std::vector<double> samples_;                ///< of the incomplete block
  std::optional<spectra::ShaftSpeed> before_;  ///< what the previous block showed with certainty
  double reported_rpm_;
  /// A speed and the stream time from which on it counts.
  struct Since {
    double from_s;
    double rpm;
  };
  std::vector<Since> shown_;  ///< ascending; the first one counts until the second one does
};

}  // namespace piae::monitor
