#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::run {

/// Options --methods, --ratios, --seeds, --classifiers and --nothing-known of a program that looks
/// at what a run holds; each may be left out.
void bind_begun_cells(const cli::Options& command, GridOptions& options);

/// The cells that there should be: what is asked for, and for a list that is empty every method,
/// ratio, classifier or seed of which there is a folder. A run that was only begun has a few
/// folders and logs, and lacks cells. Throws Error(usage) as resolve() does, Error(input_missing)
/// where nothing is asked for and the folder holds nothing.
Grid resolve_begun(const Layout& layout, GridOptions options);

/// The methods of which anything was begun, in the order of the catalogue.
std::vector<std::string> methods_begun(const Layout& layout);

/// Whether any diagnosis was begun.
bool holds_cells(const Layout& layout);

}  // namespace piae::run
