#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"

namespace piae::report {

/// Stands in the place of a ratio's name for the mean over the ratios of a method.
inline const std::string mean_of_ratios = "mean";

/// The mean over the ratios of one method, seed by seed. It is of the ratios and seeds that have no
/// gap among them (report/largest_block.hpp): of all, where the run has all. Empty where these are
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
