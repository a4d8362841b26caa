#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Returns the mean squared Euclidean distance over the n (n - 1) ordered pairs of different
/// windows. Throws std::logic_error for fewer than two windows.
double mean_squared_distance(const Windows& windows);

/// Returns the squared maximum mean discrepancy between two equally large sets of windows:
///
///     MMD^2 = 1/n^2 sum_ij [k(x_i, x_j) + k(y_i, y_j) - 2 k(x_i, y_j)]
///     k(x, y) = sum_m exp(-|x - y|^2 / (b m)),  m = 1, 2, 4, 8, 16,  b = squared_distance / 4
///
/// The paper's eq. 27 is MMD, not its square, and gives neither kernel nor estimator. This function
/// follows common code that calls its result MMD (Long et al. 2015, "Learning transferable features
/// with deep adaptation networks"): the square, by its biased estimator (the pairs i = j count),
/// with the sum of five Gaussian kernels and bandwidths from a mean squared distance. Their
/// distance is pooled over both sets. Scoring uses only the real windows of the class, so that all
/// generators are compared with the same kernel.
///
/// Because of the bias, two sets of n windows from the same distribution, pairwise about equally
/// far apart, give about 6.2 / n, not 0. Examples, CWRU's IR007 at stride 200, n = 301: 0.020 for
/// other real windows, 0.036 for white noise of the same RMS, 0.64 for five real windows repeated
/// (paper-notes, row 10). MMD, not squared, would be 0.14, 0.19, 0.80.
///
/// The sums do not depend on the number of threads. Throws std::logic_error for sets of different
/// shape, for sets without windows, and for a squared distance that is not positive.
double mmd_squared(const Windows& x, const Windows& y, double squared_distance);

}  // namespace piae::scoring
