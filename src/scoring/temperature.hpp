#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// Returns the softmax of logits / temperature, row-major [n, classes] (Guo et al. 2017, "On
/// calibration of modern neural networks", eq. 9).
std::vector<float> tempered(std::span<const float> logits, std::size_t classes, double temperature);

/// Returns the temperature with the least mean negative log-likelihood of these n labels. All
/// classes have equal weight, whatever their number of windows. The temperature is found by Brent's
/// method over its logarithm, between 1/50 and 50, and is above 1 for an overconfident classifier.
/// The target of each label is the probability (n + 1) / (n + 2), with the rest for the other
/// classes, because even without mistakes so far the next prediction may be wrong (Platt 1999,
/// "Probabilistic outputs for support vector machines", Section 2.2). Throws std::logic_error
/// without labels.
double best_temperature(std::span<const float> logits, std::span<const Label> labels,
                        std::size_t classes);

}  // namespace piae::scoring
