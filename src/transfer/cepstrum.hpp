#pragma once

#include <Eigen/Core>

namespace piae::transfer {

/// Spectra here have the bins 0 .. frame / 2 of a frame of an even number of samples.

/// A logarithmic spectrum without what changes faster along the frequency than with `quefrency`
/// samples, such as the lines of a rhythm that is slower. The cepstrum falls off in a straight line
/// over the last three tenths of that.
Eigen::ArrayXd liftered(const Eigen::ArrayXd& log_amplitude, double quefrency);

/// The response of minimum phase that has this amplitude (Oppenheim and Schafer 1989, Section
/// 12.7): the one that answers a blow soonest.
Eigen::ArrayXcd minimum_phase(const Eigen::ArrayXd& log_amplitude);

/// The real samples of a frame that has this spectrum.
Eigen::ArrayXd samples_of(const Eigen::ArrayXcd& spectrum);

}  // namespace piae::transfer
