#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"

namespace piae::report {

/// A column of a table in which methods are compared.
struct RatioColumn {
  std::string ratio;  ///< its name
  std::string label;  ///< for people
};

/// The ratios that any of the rows has, in the order of Table 5.
std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows);

/// The same without 100to1, at which only `none` has a row and nothing can be compared with it.
std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows);

/// The row of a method at a ratio, or null. For `none` it is its only row, whatever the ratio.
const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio);

}  // namespace piae::report
