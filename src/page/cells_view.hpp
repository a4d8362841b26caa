#pragma once

#include <cstddef>
#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Limit of cells that get a row each. A longer page could not be sent by mail.
inline constexpr std::size_t most_listed_cells = 3000;

/// Returns every cell with its number, artefact and digest, from which all means were computed.
/// Above most_listed_cells, returns a row for all seeds of a diagnosis.
Html cells_view(const std::vector<DatasetContents>& datasets);

/// Returns the commit, libraries and machine that made the cells, and the recordings they came
/// from.
Html provenance_view(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
