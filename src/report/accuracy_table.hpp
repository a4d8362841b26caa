#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/published.hpp"
#include "run/collect.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// One method at one ratio over its seeds. The numbers are accuracies in percent, or gains in
/// points.
struct AccuracyRow {
  std::string dataset;
  std::string method;
  std::string ratio;
  std::int64_t generated_per_class = 0;
  double true_ratio = 0;
  std::vector<double> values;  ///< by seed
  scoring::Summary summary;    ///< of the values
  /// What the paper publishes: of this dataset, or of its counterpart (report/paper_reference.hpp),
  /// which is for orientation only. At most one of them is there.
  std::optional<double> published;
  std::optional<double> orientation;
};

/// A row for each combination of the grid, in its order. `results` must have all cells of the grid.
std::vector<AccuracyRow> accuracy_rows(const run::Grid& grid, const run::Results& results,
                                       const Published& published);

/// Each method that has a row, once, in the order of the rows.
std::vector<std::string> methods_of(const std::vector<AccuracyRow>& rows);
/// The rows of one method.
std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method);

/// What generated windows are worth, in points: for each row the accuracy minus that of `none`,
/// seed by seed. The published gain is the difference of the published accuracies. Returns no rows
/// where `none` has no row.
std::vector<AccuracyRow> gain_rows(const std::vector<AccuracyRow>& rows);

/// Stands in the place of a ratio's name for the mean over the ratios of a method.
inline const std::string mean_of_ratios = "mean";

/// A row for each method that has several ratios: the mean over them, seed by seed.
std::vector<AccuracyRow> mean_rows(const std::vector<AccuracyRow>& rows);

/// accuracy.csv and gains.csv:
/// dataset,method,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,published in percent
/// or points; `seeds` is how many there are. Standard deviation and interval of a single seed are
/// empty, and so is what the paper does not publish of this very dataset.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The accuracies for a terminal, at most 100 columns wide.
std::string accuracy_text(const std::vector<AccuracyRow>& rows);

}  // namespace piae::report
