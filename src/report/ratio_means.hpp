#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"

namespace piae::report {

/// Rows and columns of a table with gaps that have no gap among them.
struct Block {
  std::vector<std::size_t> rows = {};
  std::vector<std::size_t> columns = {};
};

/// The block with the most cells among those that are tried: of each row all columns that it has,
/// with every row that has them, too. In a table without gaps that is the whole table; a row with
/// few columns is left out before it makes the others lose theirs. `has` lists for each row the
/// columns that it has, ascending. Empty where no block has so many rows and columns.
Block largest_block(const std::vector<std::vector<std::size_t>>& has, std::size_t least_rows,
                    std::size_t least_columns);

/// For each of so many rows the columns that it has, for largest_block().
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

/// Stands in the place of a ratio's name for the mean over the ratios of a method.
inline const std::string mean_of_ratios = "mean";

/// The mean over the ratios of one method, seed by seed. It is of the ratios and seeds that have no
/// gap among them (largest_block()): of all, where the run has all. Empty where these are
/// not at least two ratios. `rows` are of one method, one for each ratio.
std::optional<AccuracyRow> mean_row(const std::vector<AccuracyRow>& rows);

/// A mean_row for each method that has one.
std::vector<AccuracyRow> mean_rows(const std::vector<AccuracyRow>& rows);

/// The rows, followed by their mean_rows.
std::vector<AccuracyRow> with_means(std::vector<AccuracyRow> rows);

/// The rows of one method, with those values alone that `others`, of another method, have at the
/// same ratio and seed. `none`, which has one accuracy, has it at every ratio.
std::vector<AccuracyRow> cells_also_in(const std::vector<AccuracyRow>& rows,
                                       const std::vector<AccuracyRow>& others);

}  // namespace piae::report
