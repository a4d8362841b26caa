#pragma once

#include <string>
#include <vector>

#include "report/classifier_rows.hpp"

namespace piae::report {

/// A row of accuracies, and how a table of its classifier names it.
struct ShownRow {
  std::string name;
  AccuracyRow row;
};

/// What a table has room for that shows each method once: of each its row with the most generated
/// windows, in the order of the rows; then the bar, where it is known.
std::vector<ShownRow> rows_with_most_windows(const ClassifierRows& block);

}  // namespace piae::report
