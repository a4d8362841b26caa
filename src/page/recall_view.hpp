#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// How many windows of each class are recognised, by method, at the ratio with the most generated
/// windows; beside it missed faults and false alarms.
Html recall_view(const DatasetContents& contents);

}  // namespace piae::page
