#pragma once

#include <string>
#include <vector>

#include "report/accuracy_table.hpp"

namespace piae::report {

/// A column of a table in which methods are compared: a ratio, or the mean of the ratios.
struct RatioColumn {
  std::string ratio;
  std::string label;
};

/// Of rows and their mean_rows: ratios as in Table 5, then the mean.
std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows);

/// The same without the ratio of `none`, at which there is nothing to compare it with.
std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows);

/// The rows, followed by their mean_rows.
std::vector<AccuracyRow> with_means(std::vector<AccuracyRow> rows);

/// A method's row at a ratio, or null. That of `none`, to which ratios make no difference, stands
/// for every ratio.
const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio);

}  // namespace piae::report
