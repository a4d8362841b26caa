#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Fig. 19: the accuracy where one setting of the paper's method is moved and all others are those
/// of the grid. What was tried is what lies in the folders of the sweep; which setting that is and
/// what it is in the grid, the models say. Columns:
/// factor,place,value,centre,ratio,seed,accuracy,low,high; `place` counts the values of a factor
/// from 1, `centre` is 1 for the value that the grid has. For each seed a row, then one whose seed
/// is "mean", with the 95 % interval of the mean (empty for fewer than three seeds). The seeds are
/// those of the grid that have a sweep. Throws LeftOut where none has.
Numbers sweeps(Source& source);

}  // namespace piae::figures
