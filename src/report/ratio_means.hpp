#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"

namespace piae::report {

/// Rows and columns of a table that have no missing cell in common.
struct Block {
  std::vector<std::size_t> rows = {};
  std::vector<std::size_t> columns = {};
};

/// Returns the largest block without missing cells among those tried, or an empty block if none has
/// enough rows and columns. `has` lists for each row its columns, ascending. Each row's columns are
/// tried, with every row that has them all. A complete table stays whole. A row with few columns is
/// dropped, so that the other rows keep theirs.
Block largest_block(const std::vector<std::vector<std::size_t>>& has, std::size_t least_rows,
                    std::size_t least_columns);

/// Returns for each row the columns for which `has(row, column)` is true, for largest_block().
template <class Has>
std::vector<std::vector<std::size_t>> columns_of_rows(std::size_t rows, std::size_t columns,
                                                      const Has& has) {
  std::vector<std::vector<std::size_t>> all(rows);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      if (has(r, c)) all[r].push_back(c);
    }
  }
  return all;
}

/// Ratio name of the mean over the ratios of a method.
inline const std::string mean_of_ratios = "mean";

/// Returns the mean over the ratios of one method, seed by seed. Uses the ratios and seeds without
/// missing cells (largest_block()). Empty if fewer than two ratios remain. `rows` has one row for
/// each ratio.
std::optional<AccuracyRow> mean_row(const std::vector<AccuracyRow>& rows);

/// Returns a mean_row for each method that has one.
std::vector<AccuracyRow> mean_rows(const std::vector<AccuracyRow>& rows);

/// Returns the rows, followed by their mean_rows.
std::vector<AccuracyRow> with_means(std::vector<AccuracyRow> rows);

/// Returns the rows of one method, reduced to the ratios and seeds that `others`, the rows of
/// another method, also have. The one accuracy of `none` counts at every ratio.
std::vector<AccuracyRow> cells_also_in(const std::vector<AccuracyRow>& rows,
                                       const std::vector<AccuracyRow>& others);

}  // namespace piae::report
