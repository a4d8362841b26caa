#pragma once

#include <complex>
#include <span>

namespace piae::transfer {

/// Multiplies the spectrum of a window by gains at its bins 0 .. length / 2. What leaves at its end
/// comes in at its beginning. Throws std::logic_error for another number of gains.
void filter(std::span<double> window, std::span<const std::complex<double>> gains);

}  // namespace piae::transfer
