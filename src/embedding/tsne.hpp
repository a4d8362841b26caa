#pragma once

#include "embedding/points.hpp"

namespace piae::embedding {

/// The defaults are those of van der Maaten's and scikit-learn's programs.
struct TsneOptions {
  double perplexity = 30;            ///< how many neighbours a point has, so to speak
  int iterations = 1000;             ///< steps of the descent in all
  int exaggerated_iterations = 250;  ///< the first of them, in which neighbours attract more
  double exaggeration = 12;          ///< how much more
};

struct TsneMap {
  Points points;           ///< [N, 2], without a unit, about 0
  double kl_divergence{};  ///< what the map loses, in nats: see tsne_cost.hpp
};

/// A map of points on the plane, on which points that are near each other stay so (van der Maaten
/// and Hinton 2008, "Visualizing data using t-SNE"). Exact: all pairs count, so it is for some
/// thousands of points. The descent has their momentum and gains, starts from `first_places`, and
/// has the step length of Belkina et al. 2019 ("Automated optimized parameters for t-distributed
/// stochastic neighbor embedding").
///
/// The same points give the same map, in any order of their rows and with any number of threads.
///
/// Throws std::logic_error where the perplexity is below 1 or not below (N - 1) / 3, which takes at
/// least 5 points; for points without coordinates; and for an exaggeration that is not positive.
/// Throws Error(bad_input) where a coordinate is not finite.
TsneMap tsne(const Points& points, const TsneOptions& options = {});

}  // namespace piae::embedding
