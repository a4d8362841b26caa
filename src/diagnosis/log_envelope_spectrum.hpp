#pragma once

#include <Eigen/Core>

#include "scoring/windows.hpp"

namespace piae::diagnosis {

/// The log_spectrum() of the Hilbert envelope of one window, a row of N samples, over the whole
/// band (scoring/envelope.hpp; Smith and Randall 2015, method 1). A carrier of amplitude a that is
/// modulated as 1 + m cos(2 pi f t) has ln(a m) at f. Amplitudes below `floor` are raised to it.
Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor);

}  // namespace piae::diagnosis
