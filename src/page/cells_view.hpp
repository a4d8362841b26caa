#pragma once

#include <cstddef>
#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// More cells than this have no row each, or the page could not be sent by mail.
inline constexpr std::size_t most_listed_cells = 3000;

/// Every cell with its number, artefact and digest: what all means were made from. Of more than
/// most_listed_cells, a row for all seeds of a diagnosis.
Html cells_view(const std::vector<DatasetContents>& datasets);

/// By which commit, libraries and machine the cells were made, and from which recordings.
Html provenance_view(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
