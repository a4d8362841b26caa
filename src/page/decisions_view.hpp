#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Of each classifier what it decides over several windows of a record, and how many windows it may
/// answer: each method at its ratio with the most generated windows.
Html decisions_view(const DatasetContents& contents);

}  // namespace piae::page
