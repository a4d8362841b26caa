#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Fig. 20: t-SNE of the classifier's last hidden layer for all test windows, for the first
/// seed and each method at its ratio with the most generated windows. Columns:
/// method,class,x,y,trustworthiness,kl. Each method has a row with the trustworthiness
/// (embedding/trustworthiness.hpp) and the KL divergence (nats) of its map, then a row for each
/// window, by class. The perplexity is 30, or less for few windows. Throws Error(bad_input) for
/// fewer than 5 windows.
Numbers hidden_map(Source& source);

/// Returns Fig. 21: the same for the output layer, before the softmax.
Numbers output_map(Source& source);

}  // namespace piae::figures
