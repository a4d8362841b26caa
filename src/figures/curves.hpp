#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Fig. 7: the losses of the paper's method by epoch. Columns: seed,stage,epoch,curve,value; `seed`
/// is "mean" for the mean over the seeds, `stage` is 1 where each network follows its own loss (eq.
/// 24), 2 where all follow the total loss (eq. 25). Epochs count from 1.
Numbers loss_curves(Source& source);

/// Fig. 8: the weights alpha, beta and gamma of the losses (eq. 23), with the same columns;
/// rows of the seed "stationary" are where eq. 23 is least, 1 / (2 L) of the epoch's mean loss L.
Numbers weight_curves(Source& source);

}  // namespace piae::figures
