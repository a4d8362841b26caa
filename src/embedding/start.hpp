#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// Where t-SNE starts from: the first two principal components of the points, scaled so that the
/// first one has standard deviation 1e-4 (Kobak and Berens 2019, "The art of using t-SNE for
/// single-cell transcriptomics": so the map keeps the large-scale order of the points, and is the
/// same each time). The largest loading of each component is positive. Where points have no such
/// component, since they lie on a line or all in one place, much smaller noise takes its place: a
/// map that starts on a line would never leave it. There must be a point, and a coordinate.
Plane first_places(const Points& points);

}  // namespace piae::embedding
