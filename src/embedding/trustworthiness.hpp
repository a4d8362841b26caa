#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// How far the neighbours on a map are neighbours of the points themselves (Venna and Kaski 2001,
/// "Neighborhood preservation in nonlinear projection methods", eq. 1), from 0 to 1: 1 - 2 / (N k
/// (2N - 3k - 1)) sum_i sum_j (r(i, j) - k). Here j goes over those of the k nearest neighbours of
/// i on the map that are not among its k nearest points, and r(i, j) is the rank of j among the
/// points by distance from i, from 1. Of equally distant points the one with the smaller index
/// comes first. Chance gives about a half.
///
/// `map` is [N, any], row i of it belonging to row i of `points`. Throws std::logic_error where the
/// numbers of rows differ, where `neighbours` is not above 0 and below N / 2, and where a
/// coordinate is not finite.
double trustworthiness(const Points& points, const Points& map, Eigen::Index neighbours = 12);

}  // namespace piae::embedding
