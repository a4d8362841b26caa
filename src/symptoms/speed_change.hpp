#pragma once

#include <Eigen/Core>

namespace piae::symptoms {

/// Equally spaced bands: the middle of the first and the distance of the next, both in Hz or both
/// as a fraction of the sample rate.
struct BandPlaces {
  double first = 0;
  double step = 0;
};

/// Bands of spectra::spectral_shape_db() and of spectra::narrow_bands().
BandPlaces places_of_shape();
BandPlaces places_of_levels();

/// Returns how far a healthy spectrum may change if the shaft turns `ratio` times as fast, in dB in
/// each band; 0 for a ratio of 1. A machine's spectrum consists of forces whose frequencies follow
/// the speed, and of structures and noise whose frequencies do not. So the level L at frequency f
/// lies between L(f), if structures make it, and L(f / ratio), if the shaft makes it. Besides,
/// forces of different origins grow differently with the speed (sensor noise does not, unbalance by
/// 12 dB an octave), which shifts the balance of the bands by about 2 dB an octave:
///
///     change^2 = (L(f / ratio) - L(f))^2 + (2 log2 ratio)^2.
///
/// 2 dB is the smallest whole number with which all healthy windows of UESTC are within the
/// threshold at each of the other speeds (docs/method.md). Beyond the bands L continues as
/// constant.
Eigen::ArrayXd change_db(const Eigen::ArrayXd& levels_db, const BandPlaces& places, double ratio);

}  // namespace piae::symptoms
