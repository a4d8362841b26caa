#pragma once

#include <unsupported/Eigen/FFT>

namespace piae::scoring {

/// This thread's transforms. A plan is made once for each length; to make it takes as long as some
/// transforms. Of real numbers they give half of the spectrum, and the length must be said where a
/// half spectrum is transformed back.
Eigen::FFT<double>& planned_fft();

}  // namespace piae::scoring
