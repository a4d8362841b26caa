#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// Mean squared Euclidean distance over the n (n - 1) ordered pairs of different windows. Throws
/// std::logic_error when there are fewer than two.
double mean_squared_distance(const Windows& windows);

/// Squared maximum mean discrepancy between two equally large sets of windows:
///
///     MMD^2 = 1/n^2 sum_ij [k(x_i, x_j) + k(y_i, y_j) - 2 k(x_i, y_j)]
///     k(x, y) = sum_m exp(-|x - y|^2 / (b m)),  m = 1, 2, 4, 8, 16,  b = squared_distance / 4
///
/// The paper's eq. 27 is MMD, not its square, and names neither a kernel nor an estimate. What
/// stands here is what the field's code computes and calls MMD (Long et al. 2015, "Learning
/// transferable features with deep adaptation networks"): the square, in its biased estimate (the
/// pairs i = j are counted), with five Gaussian kernels added and bandwidths from a mean squared
/// distance. There the distance is pooled over both sets. For scoring it is that of the real
/// windows of the class alone, so that all generators are measured by the same kernel and can be
/// compared.
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
