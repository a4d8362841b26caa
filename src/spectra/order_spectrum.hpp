#pragma once

#include <Eigen/Core>

#include "spectra/bands.hpp"

namespace piae::spectra {

/// How far an envelope spectrum stands above its floor, as the decimal logarithm of a ratio of
/// powers, at orders: multiples of the shaft's frequency, every `step` from `first` on. In orders
/// the lines of a bearing stand at the same places whatever the speed.
struct OrderSpectrum {
  static constexpr double first = 0.2;
  static constexpr double step = 0.05;

  Eigen::ArrayXd heights;

  /// The height at an order, which must lie within the spectrum, on the straight line between its
  /// neighbours. Both are first raised to `lowest` and lowered to `highest`.
  [[nodiscard]] double at(double order, double lowest, double highest) const;
};

/// The order spectrum of one window, up to an order of at least `last`. The bank is one for windows
/// of this length. With X the window's whitened spectrum (floors.hpp) and G a band (bands.hpp),
///
///     e = |analytic signal of G X|^2,  S = |FFT(Hann (e - mean e))|^2, padded to twice the length,
///     L = log10(S / floor + 1e-3),     R = mean of L over all bands.
///
/// This is the envelope (or high-frequency resonance) technique, McFadden and Smith 1984, on the
/// squared envelope, as Randall and Antoni 2011 (section 5) advise, in every band instead of one
/// that is chosen, say by spectral kurtosis (Antoni 2006 and 2007): a choice that a single window
/// of some turns is too short for. The power of noise has an exponential distribution, whose median
/// is its mean times ln 2; so the floor is the running median / ln 2, over 1.6 orders or nine bins,
/// whichever is more. Noise alone has R about -0.25 everywhere, the mean of the logarithm of such a
/// distribution. A line is 1 for ten times the floor. Above the width of
/// a band, 1200 Hz or what half the sample rate leaves of it, is no line: of a fast shaft the
/// higher harmonics are low, of healthy and faulty windows alike.
OrderSpectrum order_spectrum(const Eigen::RowVectorXd& window, const FilterBank& bank,
                             double shaft_hz, double last);

}  // namespace piae::spectra
