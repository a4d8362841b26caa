#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Which method to take, why, and what it gets wrong; what the most accurate of each effort
/// reaches; what is recommended at each ratio; and what is recognised of each class.
Html recommendation_view(const DatasetContents& contents);

}  // namespace piae::page
