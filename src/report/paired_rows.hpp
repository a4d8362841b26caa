#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/accuracy_table.hpp"
#include "report/ratio_columns.hpp"
#include "scoring/paired.hpp"
#include "text/table.hpp"

namespace piae::report {

/// Accuracies of a method beside others of the same seeds, at one ratio or in the mean of ratios.
struct PairedRow {
  std::string method;
  std::string ratio;
  scoring::PairedComparison paired;  ///< in points
  std::optional<double> p_holm;      ///< see correct()
};

/// The first minus the second, which has the same seeds; under the first's method.
PairedRow pair(const AccuracyRow& row, const std::string& ratio, const AccuracyRow& other);

/// Holm's correction. The methods that are compared at the same ratio are a family, and those in
/// the mean of the ratios another.
void correct(std::vector<PairedRow>& rows);

/// seeds,mean_difference,ci95_low,ci95_high,rank_biserial,p,p_holm: fields of a CSV file. All but
/// the first two are empty for one seed.
std::vector<std::string> paired_header();
std::vector<std::string> paired_fields(const PairedRow& row);

/// The rows of a method, up to four: difference, its interval, effect, p. `name` stands in the
/// first cell of the first. Cells without a row are empty.
void add_paired(text::Table& table, const std::string& name, const std::string& method,
                const std::vector<PairedRow>& rows, const std::vector<RatioColumn>& columns);

/// What those rows mean, and where the seeds are too few to tell anything.
std::string paired_note(const std::vector<PairedRow>& rows);

}  // namespace piae::report
