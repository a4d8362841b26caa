#pragma once

#include <memory>
#include <span>
#include <vector>

namespace piae::signal {

/// Resamples a signal by libsoxr in double precision at its "very high quality" (linear phase, pass
/// band to 91 % of the lower Nyquist frequency, 175 dB rejection), with one thread. The result has
/// floor(n * to / from) samples, sample i at time i / to_hz. The first and last few hundred samples
/// fade, because soxr sees zeros before and after the signal. Equal rates return the signal
/// unchanged. Throws Error(failed) with soxr's reason.
std::vector<double> resample(std::span<const double> signal, double from_hz, double to_hz);

/// resample() for a signal that arrives in pieces. The result does not depend on the pieces, except
/// for the rounding of a double. Equal rates return the signal unchanged.
class StreamResampler {
 public:
  /// Throws Error(failed) with soxr's reason, as all members do.
  StreamResampler(double from_hz, double to_hz);
  ~StreamResampler();
  StreamResampler(StreamResampler&&) noexcept;
  StreamResampler& operator=(StreamResampler&&) noexcept;

  /// Takes the next samples and appends the resampled signal so far. The output lags by some
  /// hundred samples, which soxr holds back.
  void add(std::span<const double> samples, std::vector<double>& resampled);
  /// Appends the samples held back, after the last input.
  void finish(std::vector<double>& resampled);

 private:
  struct State;
  std::unique_ptr<State> state_;  ///< null if the rates are equal
};

}  // namespace piae::signal
