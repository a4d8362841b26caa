#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Figs 13 and 14: MMD and RMSE of the generated windows by class and method, and the other
/// metrics of scoring/quality.hpp, which do not reward silence. Columns:
/// metric,class,method,seed,value; `seed` is "mean" for the mean over the seeds. The methods are
/// those of the paper's comparison.
Numbers quality_of_methods(Source& source);

/// Returns Figs 16 and 17: the same for the paper's models and those of its outlook. Throws LeftOut
/// if the grid has none of the ablations.
Numbers quality_of_models(Source& source);

}  // namespace piae::figures
