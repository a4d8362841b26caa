#pragma once

#include <vector>

#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns the effect of each part of a method, a picture for each method with changed settings
/// except the paper's (see Fig. 19). The points and their order are those of the table that the
/// stage `sweep` wrote; the numbers use all cells of the run. Columns:
/// setting,instead_of,ratio,classifier,seed,difference,low,high,whole; `instead_of` is the method's
/// own value, read from its model, and `whole` its mean accuracy at these seeds in percent. Each
/// seed has a row, then one whose seed is "mean", with the 95 % interval of the mean (empty for
/// fewer than three seeds). Throws LeftOut without such a table.
std::vector<Picture> worth_of_parts(Source& source);

}  // namespace piae::figures
