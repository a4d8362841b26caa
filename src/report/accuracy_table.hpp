#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/collect.hpp"
#include "report/published.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// One combination of method and ratio over its seeds. All accuracies in percent.
struct AccuracyRow {
  std::string dataset;
  std::string method;
  std::string ratio;
  std::int64_t generated_per_class = 0;
  double true_ratio = 0;
  std::vector<double> percents;  ///< by seed
  scoring::Summary summary;
  std::optional<double> published;
};

/// One row a combination, in the order of the grid. `results` has all cells of the grid.
std::vector<AccuracyRow> accuracy_rows(const Grid& grid, const Results& results,
                                       const Published& published);

/// accuracy.csv:
/// dataset,method,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,published in percent;
/// `seeds` is how many there are. Empty: std and interval of one seed alone, and what the paper
/// does not publish.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The same for a terminal.
std::string accuracy_text(const std::vector<AccuracyRow>& rows);

/// "10:1", and "2:1 (3.33:1)" where the true ratio is not what the name says.
std::string ratio_label(const AccuracyRow& row);
/// "85.40 ± 1.20", "[84.01, 86.79]"; without a spread "85.40" and nothing.
std::string mean_label(const scoring::Summary& summary);
std::string interval_label(const scoring::Summary& summary);

}  // namespace piae::report
