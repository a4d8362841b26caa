#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// Returns the starting positions of t-SNE: the first two principal components of the points,
/// scaled so that the first has standard deviation 1e-4. So the map keeps the large-scale order of
/// the points and is reproducible (Kobak and Berens 2019, "The art of using t-SNE for single-cell
/// transcriptomics"). The largest loading of each component is positive. If a component is missing,
/// because the points lie on a line or coincide, much smaller noise replaces it: a map that starts
/// on a line would never leave it. Needs at least one point and one coordinate.
Plane first_places(const Points& points);

}  // namespace piae::embedding
