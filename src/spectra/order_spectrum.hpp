#pragma once

#include <Eigen/Core>

#include "spectra/bands.hpp"

namespace piae::spectra {

/// Height of an envelope spectrum above its floor, as the decimal logarithm of a ratio of powers,
/// at orders (multiples of the shaft frequency), every `step` from `first` on. The lines of a
/// bearing have the same orders at every speed.
struct OrderSpectrum {
  static constexpr double first = 0.2;
  static constexpr double step = 0.05;

  Eigen::ArrayXd heights;

  /// Returns the height at an order, which must lie within the spectrum, by linear interpolation
  /// between its neighbours. Both neighbours are first clipped to `lowest` .. `highest`.
  [[nodiscard]] double at(double order, double lowest, double highest) const;
};

/// Returns the order spectrum of one window, up to an order of at least `last`. The bank must be
/// for windows of this length. With X the window's whitened spectrum (floors.hpp) and G a band
/// (bands.hpp),
///
///     e = |analytic signal of G X|^2,  S = |FFT(Hann (e - mean e))|^2, padded to twice the length,
///     L = log10(S / floor + 1e-3),     R = mean of L over all bands.
///
/// This is the envelope (or high-frequency resonance) technique (McFadden and Smith 1984) on the
/// squared envelope, as Randall and Antoni 2011 (section 5) advise. It uses every band instead of
/// choosing one, for example by spectral kurtosis (Antoni 2006 and 2007): a single window of some
/// turns is too short for that choice.
/// The power of noise has an exponential distribution, whose median is its mean times ln 2. So the
/// floor is the running median / ln 2, over 1.6 orders or nine bins, whichever is more. Noise alone
/// has R about -0.25 everywhere, the mean of the logarithm of that distribution. A line of ten
/// times the floor has R = 1. Lines do not occur above the width of a band (1200 Hz, or less near
/// half the sample rate): for a fast shaft the higher harmonics are low, in healthy and faulty
/// windows alike.
///
/// `prewhitening` from 0 to 1 divides X by that power of its own amplitude, bin by bin. 1 is
/// cepstral prewhitening (Borghesani, Pennacchi, Randall, Sawalhi and Ricci 2013): lines of shaft
/// and gears, which X keeps, are as low as the noise, but so are the harmonics of impacts at a
/// steady rate. A power between them weakens both.
OrderSpectrum order_spectrum(const Eigen::RowVectorXd& window, const FilterBank& bank,
                             double shaft_hz, double last, double prewhitening = 0);

}  // namespace piae::spectra
