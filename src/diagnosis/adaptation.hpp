#pragma once

namespace piae::diagnosis {

/// Adaptation of a classifier to unlabelled windows of the tested condition: it also learns
/// features by which a domain classifier (domain_classifier.hpp) cannot tell them from labelled
/// windows.
enum class Adaptation {
  none,
  marginal,    ///< DANN: that classifier sees the hidden units (Ganin et al. 2016)
  conditional  ///< CDAN: their products with the class probabilities (Long et al. 2018, eq. 5)
};

}  // namespace piae::diagnosis
