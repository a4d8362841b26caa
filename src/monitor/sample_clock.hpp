#pragma once

#include <cstddef>
#include <cstdint>

namespace piae::monitor {

/// Finds samples of a real-time stream that arrive later than their rate implies. The lag is the
/// clock time less the time of the samples; its growth counts, not its value.
class SampleClock {
 public:
  /// Reports a lag that grows by more than `late_s`. Clocks of computers and recorders typically
  /// differ by 50 parts per million each, so growth of up to `drift` is never counted.
  SampleClock(double rate_hz, double late_s) : rate_hz_(rate_hz), late_s_(late_s) {}

  /// Takes the time of any clock in s and the number of samples so far. Returns the delay in s if
  /// it exceeds `late_s`, and measures later samples from the new lag. Returns 0 otherwise.
  double late_by(double now_s, std::uint64_t samples);

  [[nodiscard]] std::size_t times() const { return times_; }
  [[nodiscard]] double all_s() const { return all_s_; }

  static constexpr double drift = 200e-6;

 private:
  double rate_hz_;
  double late_s_;
  bool started_ = false;
  double last_s_ = 0;
  double least_lag_s_ = 0;
  std::size_t times_ = 0;
  double all_s_ = 0;
};

}  // namespace piae::monitor
