#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "figures/catalogue.hpp"
#include "run/layout.hpp"

namespace piae::figures {

/// Returns the names of a figure's pictures whose numbers are in the folder of a run, in
/// alphabetical order: NAME, or NAME@PART for each part. Layout::figure_csv() gives their files.
std::vector<std::string> stored_pictures(const run::Layout& layout, const Figure& figure);

/// Makes the numbers of a figure and writes them, NAME.csv or NAME@PART.csv for each part.
/// Unchanged files are not rewritten. Pictures that the figure no longer has are removed. If a
/// required file is missing or refused, all pictures are removed, so that none is out of date, and
/// Error is thrown as Source does. Returns the current files of the figure.
std::vector<std::filesystem::path> save_pictures(Source& source, const Figure& figure);

}  // namespace piae::figures
