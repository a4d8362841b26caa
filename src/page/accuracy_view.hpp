#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// What a data set shows first: the verdict in sentences, accuracies with the published ones beside
/// them, and gains over none.
Html accuracy_view(const DatasetContents& contents);

}  // namespace piae::page
