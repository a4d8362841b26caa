#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

// Views of the accuracies of one data set. All numbers come from tables of report/; these views
// place them.

/// Returns the verdict in sentences, accuracies next to the published ones, and gains over none.
Html accuracy_view(const DatasetContents& contents);

/// Returns the share of recognised windows of each class, by method.
Html recall_view(const DatasetContents& contents);

/// Returns for each classifier its decisions over several windows of a record, and the share of
/// windows that it can answer.
Html decisions_view(const DatasetContents& contents);

/// Returns the recommended method, its reason and its errors; then the accuracy of the best method
/// of each effort, the recommendation at each ratio, and the recall of each class.
Html recommendation_view(const DatasetContents& contents);

}  // namespace piae::page
