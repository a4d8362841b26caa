#pragma once

#include <Eigen/Core>

namespace piae::spectra {

/// Returns the squared envelope of the whitened signal (floors.hpp). Whitening lets the whole band
/// count, so no band has to be chosen (Randall and Antoni 2011, sections 4 and 5).
Eigen::RowVectorXd whole_band_envelope(const Eigen::RowVectorXd& signal, double rate_hz);

}  // namespace piae::spectra
