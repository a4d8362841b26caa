#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// Returns to what extent neighbours on a map are neighbours among the points (Venna and Kaski
/// 2001, "Neighborhood preservation in nonlinear projection methods", eq. 1), from 0 to 1: 1 - 2 /
/// (N k (2N - 3k - 1)) sum_i sum_j (r(i, j) - k). Here j runs over those of the k nearest
/// neighbours of i on the map that are not among its k nearest points, and r(i, j) is the rank of j
/// among the points by distance from i, from 1. Ties go to the smaller index. A random map gives
/// about a half.
///
/// `map` is [N, any]; its row i belongs to row i of `points`. Throws std::logic_error if the
/// numbers of rows differ, if `neighbours` is not above 0 and below N / 2, or if a coordinate is
/// not finite.
double trustworthiness(const Points& points, const Points& map, Eigen::Index neighbours = 12);

}  // namespace piae::embedding
