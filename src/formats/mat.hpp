#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// Returns a MATLAB file of version 5: the samples as the single matrix `windows`, [n, length], and
/// a variable for each fact: a text or a number if it holds for all windows, else a column; a cell
/// array for texts or lists. libmatio is not used, because it only writes to a path and puts the
/// date into its files. Throws Error(usage) for data that is too large for the format.
std::string mat(const Exported& exported);

}  // namespace piae::formats
