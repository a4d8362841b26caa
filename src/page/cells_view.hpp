#pragma once

#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Every cell with its number, artefact and digest: what all means were made from.
Html cells_view(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
