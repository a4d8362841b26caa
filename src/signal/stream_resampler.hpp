#pragma once

#include <memory>
#include <span>
#include <vector>

namespace piae::signal {

/// resample() of a signal that comes in pieces: what they give together is the same, to the
/// rounding of a double, however it was cut. Equal rates give the signal unchanged.
class StreamResampler {
 public:
  /// Throws Error(failed) with soxr's reason, as all members do.
  StreamResampler(double from_hz, double to_hz);
  ~StreamResampler();
  StreamResampler(StreamResampler&&) noexcept;
  StreamResampler& operator=(StreamResampler&&) noexcept;

  /// Takes the samples that come next, and appends those that follow from all until now. They lag
  /// behind by some hundred samples, which soxr holds back.
  void add(std::span<const double> samples, std::vector<double>& resampled);
  /// Appends what was held back, when no more will come.
  void finish(std::vector<double>& resampled);

 private:
  struct State;
  std::unique_ptr<State> state_;  ///< none where the rates are equal
};

}  // namespace piae::signal
