#pragma once

#include <Eigen/Core>

#include "signal/recordings.hpp"

namespace piae::transfer {

/// How eq. 13 without its contacts answers one blow, M x'' + c x' + k x = F: the logarithm of the
/// amplitude of its acceleration, w^2 / |k - M w^2 + i w c|, at `bins` frequencies from 0 Hz to
/// half the sampling rate, with the mean 0. At 0 Hz, where nothing is, it is as at the next bin.
Eigen::ArrayXd ring_answer(const signal::DynamicParameters& ring, double mass_kg, Eigen::Index bins,
                           double rate_hz);

/// The k and c of the strongest resonance in an answer of that form: w^2 = k / M where it is
/// highest, and c = M times the width, in rad/s, within which it has more than half of that power.
/// A structure has several resonances, of which this is one.
signal::DynamicParameters strongest_ring(const Eigen::ArrayXd& answer, double mass_kg,
                                         double rate_hz);

}  // namespace piae::transfer
