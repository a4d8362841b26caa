#pragma once

#include <vector>

#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// What each part of a method is worth, a picture for each method whose settings were moved and
/// that is not the paper's (whose Fig. 19 is another). The points and their order are those of the
/// table that the stage `sweep` wrote, the numbers are of all cells that the run holds. Columns:
/// setting,instead_of,ratio,classifier,seed,difference,low,high,whole; `instead_of` is what
/// the method has, as its model says, and `whole` its mean accuracy at these seeds in percent. For
/// each seed a row, then one whose seed is "mean", with the 95 % interval of the mean (empty for
/// fewer than three seeds). Throws LeftOut where there is no such table.
std::vector<Picture> worth_of_parts(Source& source);

}  // namespace piae::figures
