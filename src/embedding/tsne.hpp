#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// The defaults are those of van der Maaten's program and of scikit-learn.
struct TsneOptions {
  double perplexity = 30;            ///< effective number of neighbours of a point
  int iterations = 1000;             ///< steps of the descent in total
  int exaggerated_iterations = 250;  ///< the first steps, in which the attraction is larger
  double exaggeration = 12;          ///< factor of the attraction in those steps
};

struct TsneMap {
  Points points;           ///< [N, 2], without a unit, centred on 0
  double kl_divergence{};  ///< information that the map loses, in nats: see tsne_cost.hpp
};

/// Returns a map of points on the plane that keeps near points near (van der Maaten and Hinton
/// 2008, "Visualizing data using t-SNE"). Exact: uses all pairs, so it suits some thousands of
/// points. The descent uses their momentum and gains, starts from `first_places`, and uses the step
/// length of Belkina et al. 2019 ("Automated optimized parameters for t-distributed stochastic
/// neighbor embedding").
///
/// The map does not depend on the order of the rows or on the number of threads.
///
/// Throws std::logic_error if the perplexity is below 1 or not below (N - 1) / 3 (so at least 5
/// points are needed), if points have no coordinates, or if the exaggeration is not positive.
/// Throws Error(bad_input) if a coordinate is not finite.
TsneMap tsne(const Points& points, const TsneOptions& options = {});

}  // namespace piae::embedding
