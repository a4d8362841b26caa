#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Fig. 19: the accuracy if one setting of the paper's method changes and all others are
/// those of the grid. The folders of the sweep give the tried points; the models give the setting
/// and its value in the grid. Columns: factor,place,value,centre,ratio,seed,accuracy,low,high;
/// `place` counts the values of a factor from 1, `centre` is 1 for the value of the grid. Each seed
/// has a row, then one whose seed is "mean", with the 95 % interval of the mean (empty for fewer
/// than three seeds). The seeds are those of the grid that have a sweep. Throws LeftOut if none
/// has.
Numbers sweeps(Source& source);

}  // namespace piae::figures
