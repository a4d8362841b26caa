#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Fig. 20: t-SNE of what the classifier's last hidden layer makes of all test windows, of the
/// first seed; each method at its ratio with the most generated windows. Columns:
/// method,class,x,y,trustworthiness,kl. A method has a row that says how far its map can be trusted
/// (embedding/trustworthiness.hpp) and what it loses (KL divergence in nats), and then a row for
/// each window, by class. The perplexity is 30, less where there are few windows. Throws
/// Error(bad_input) for fewer than 5 windows.
Numbers hidden_map(Source& source);

/// Fig. 21: the same of the output layer, before the softmax.
Numbers output_map(Source& source);

}  // namespace piae::figures
