#pragma once

#include <memory>
#include <span>
#include <vector>

namespace piae::signal {

/// A signal at another sample rate, by libsoxr in double precision at its "very high quality"
/// (linear phase, pass band to 91 % of the lower Nyquist frequency, 175 dB rejection), one thread.
/// The result has floor(n * to / from) samples, sample i at time i / to_hz; before and after the
/// signal soxr sees silence, so that the first and last few hundred samples fade. Equal rates
/// return the signal unchanged. Throws Error(failed) with soxr's reason.
std::vector<double> resample(std::span<const double> signal, double from_hz, double to_hz);

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
