#pragma once

#include <cstddef>
#include <cstdint>

namespace piae::monitor {

/// Tells of a stream in real time when its samples come later than their rate says. The lag is the
/// time on the clock less that of the samples; what counts is by how much it has grown.
class SampleClock {
 public:
  /// `late_s`: by how much a lag may grow before it is told. The clocks of a computer and of a
  /// recorder run apart, by 50 millionths of a second in each as a rule: that much growth, and some
  /// more, is never counted.
  SampleClock(double rate_hz, double late_s) : rate_hz_(rate_hz), late_s_(late_s) {}

  /// So many samples have come until now, which is read from any clock in s. By how much they are
  /// late, where that is to be told; then what comes is measured against this new lag. 0 otherwise.
  double late_by(double now_s, std::uint64_t samples);

  [[nodiscard]] std::size_t times() const { return times_; }
  [[nodiscard]] double all_s() const { return all_s_; }

  static constexpr double drift = 200e-6;

 private:
  double rate_hz_;
  double late_s_;
  bool begun_ = false;
  double last_s_ = 0;
  double least_lag_s_ = 0;
  std::size_t times_ = 0;
  double all_s_ = 0;
};

}  // namespace piae::monitor
