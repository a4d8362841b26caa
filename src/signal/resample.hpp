#pragma once

#include <span>
#include <vector>

namespace piae::signal {

/// A signal at another sample rate, by libsoxr in double precision at its "very high quality"
/// (linear phase, pass band to 91 % of the lower Nyquist frequency, 175 dB rejection), one thread.
/// The result has floor(n * to / from) samples, sample i at time i / to_hz; before and after the
/// signal soxr sees silence, so that the first and last few hundred samples fade. Equal rates
/// return the signal unchanged. Throws Error(failed) with soxr's reason.
std::vector<double> resample(std::span<const double> signal, double from_hz, double to_hz);

}  // namespace piae::signal
