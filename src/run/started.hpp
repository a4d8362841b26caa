#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"

namespace piae::run {

/// Binds --methods, --ratios, --seeds, --classifiers and --nothing-known for a program that shows
/// what a run holds. Each option may be left out.
void bind_started_cells(const cli::Options& command, GridOptions& options);

/// Returns the cells that should exist: the requested ones; an empty list stands for every method,
/// ratio, classifier or seed with a folder. A run that has only started has few folders and logs,
/// and cells are missing. Throws Error(usage) as resolve() does, and Error(input_missing) if
/// nothing is requested and the folder is empty.
Grid resolve_started(const Layout& layout, GridOptions options);

/// Returns the methods with started steps, in the order of the catalogue.
std::vector<std::string> methods_started(const Layout& layout);

/// True if any diagnosis has started.
bool holds_cells(const Layout& layout);

}  // namespace piae::run
