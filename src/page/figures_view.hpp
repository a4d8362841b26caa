#pragma once

#include <string>
#include <vector>

#include "page/html.hpp"
#include "page/pictures.hpp"

namespace piae::page {

/// The figures of a data set: each with an anchor, a caption that says how to read it, its numbers
/// to save and where they came from; then those that are missing, and why.
Html figures_view(const std::string& dataset, const std::vector<FigureContents>& figures);

}  // namespace piae::page
