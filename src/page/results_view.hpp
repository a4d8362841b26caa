#pragma once

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

// What a page shows of the accuracies of one data set. All numbers are those of tables that report/
// makes; these views place them.

/// What a data set shows first: the verdict in sentences, accuracies with the published ones beside
/// them, and gains over none.
Html accuracy_view(const DatasetContents& contents);

/// How many windows of each class are recognised, by method.
Html recall_view(const DatasetContents& contents);

/// Of each classifier what it decides over several windows of a record, and how many windows it may
/// answer.
Html decisions_view(const DatasetContents& contents);

/// Which method to take, why, and what it gets wrong; what the most accurate of each effort
/// reaches; what is recommended at each ratio; and what is recognised of each class.
Html recommendation_view(const DatasetContents& contents);

}  // namespace piae::page
