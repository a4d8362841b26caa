#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "figures/catalogue.hpp"
#include "run/layout.hpp"

namespace piae::figures {

/// The names of a figure's pictures whose numbers lie in the folder of a run, in alphabetical
/// order: NAME, or NAME@PART for each part. Layout::figure_csv() has their files.
std::vector<std::string> stored_pictures(const run::Layout& layout, const Figure& figure);

/// Makes the numbers of a figure and writes them, NAME.csv or NAME@PART.csv for each part. A file
/// that would not change is left as it is. Pictures that the figure has no longer are removed, and
/// all of them where a file that it needs is missing or refused, so that none shows what is no
/// longer so; Error is thrown then, as Source says. Returns the files that the figure has now.
std::vector<std::filesystem::path> save_pictures(Source& source, const Figure& figure);

}  // namespace piae::figures
