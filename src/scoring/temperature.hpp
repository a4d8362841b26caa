#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// Softmax of logits / temperature, row-major [n, classes] (Guo et al. 2017, "On calibration of
/// modern neural networks", eq. 9).
std::vector<float> tempered(std::span<const float> logits, std::size_t classes, double temperature);

/// The temperature with the least mean negative log-likelihood of these n labels, each class with
/// the same weight however many windows it has (found by Brent's method over its logarithm, between
/// 1/50 and 50). Above 1 for a classifier that is too sure. Not the labels themselves are asked for
/// but, as Platt (1999, "Probabilistic outputs for support vector machines", Section 2.2) does, the
/// chance (n + 1) / (n + 2) of each, and that of the other classes for the rest: where no window is
/// mistaken, the next one still may be. Throws std::logic_error where there is no label.
double best_temperature(std::span<const float> logits, std::span<const Label> labels,
                        std::size_t classes);

}  // namespace piae::scoring
