#pragma once

#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// By which commit, libraries and machine the cells were made, and from which recordings.
Html provenance_view(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
