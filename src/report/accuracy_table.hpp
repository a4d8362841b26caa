#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/published.hpp"
#include "run/collect.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// One combination of method and ratio over its seeds. An accuracy in percent, or a gain in points.
struct AccuracyRow {
  std::string dataset;
  std::string method;
  std::string ratio;
  std::int64_t generated_per_class = 0;
  double true_ratio = 0;
  std::vector<double> values;  ///< by seed
  scoring::Summary summary;
  /// What the paper publishes of this dataset, or else of its counterpart (report/counterpart.hpp),
  /// which is for orientation only.
  std::optional<double> published;
  std::optional<double> orientation;
};

/// One row a combination, in the order of the grid. `results` has all cells of the grid.
std::vector<AccuracyRow> accuracy_rows(const run::Grid& grid, const run::Results& results,
                                       const Published& published);

/// Each method that has a row, once, in the order of the rows; and the rows of one.
std::vector<std::string> methods_of(const std::vector<AccuracyRow>& rows);
std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method);

/// What generated windows are worth, in points: the accuracy with them, minus that without any of
/// the same seed (of the row `none`). The published gain is the difference of the published tables.
/// No rows where `rows` has none without generated windows.
std::vector<AccuracyRow> gain_rows(const std::vector<AccuracyRow>& rows);

/// In the place of a ratio's name: the mean over the ratios of a method.
inline const std::string mean_of_ratios = "mean";

/// For each method that has several ratios a row with the mean over them, by seed.
std::vector<AccuracyRow> mean_rows(const std::vector<AccuracyRow>& rows);

/// accuracy.csv and gains.csv:
/// dataset,method,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,published in percent
/// or points; `seeds` is how many there are. Empty: std and interval of one seed alone, and what
/// the paper does not publish of this very dataset.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The accuracies for a terminal.
std::string accuracy_text(const std::vector<AccuracyRow>& rows);

}  // namespace piae::report
