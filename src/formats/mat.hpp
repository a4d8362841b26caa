#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// A MATLAB file of version 5: the samples as the single matrix `windows`, [n, length], and a
/// variable for each fact: a text or a number where it is of all windows, else a column; a cell
/// array where values are texts or lists. Written here and not by libmatio, which writes to a path
/// alone and puts the date into its files. Throws Error(usage) for what is too large for the
/// format.
std::string mat(const Exported& exported);

}  // namespace piae::formats
