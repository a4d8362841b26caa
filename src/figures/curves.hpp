#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Fig. 7: the losses of the paper's method by epoch. Columns:
/// seed,stage,epoch,curve,value; `seed` is "mean" for the mean over the seeds, `stage` is 1 while
/// each network follows its own loss (eq. 24), 2 while all follow the total loss (eq. 25). Epochs
/// count from 1.
Numbers loss_curves(Source& source);

/// Returns Fig. 8: the weights alpha, beta and gamma of the losses (eq. 23), with the same columns.
/// Rows of the seed "stationary" are the minimum of eq. 23, 1 / (2 L) for the epoch's mean loss L.
Numbers weight_curves(Source& source);

}  // namespace piae::figures
