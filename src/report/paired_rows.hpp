#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/accuracy_table.hpp"
#include "report/ratio_columns.hpp"
#include "scoring/paired.hpp"
#include "text/table.hpp"

namespace piae::report {

/// The accuracies of a method minus others of the same seeds, at one ratio or in the mean of
/// ratios.
struct PairedRow {
  std::string method;
  std::string ratio;
  scoring::PairedDifference paired;  ///< in points
  std::optional<double> p_holm;      ///< p after Holm's correction, see add_holm_p()
};

/// `row` minus `other`, seed by seed. Both have the same seeds. The result has the method of `row`.
PairedRow paired_row(const AccuracyRow& row, const std::string& ratio, const AccuracyRow& other);

/// Sets p_holm of all rows that have a p. The methods that are compared at the same ratio are one
/// family of tests, and those that are compared in the mean of the ratios another.
void add_holm_p(std::vector<PairedRow>& rows);

/// Fields of a CSV file: seeds,mean_difference,ci95_low,ci95_high,rank_biserial,p,p_holm. All but
/// the first two are empty for a single seed.
std::vector<std::string> paired_header();
std::vector<std::string> paired_fields(const PairedRow& row);

/// Adds up to four lines for a method to a table with a ratio in each column: difference, its
/// interval, effect, p. `name` stands in the first cell of the first line. A cell for which there
/// is no paired row stays empty.
void add_paired_lines(text::Table& table, const std::string& name, const std::string& method,
                      const std::vector<PairedRow>& rows, const std::vector<RatioColumn>& columns);

/// The note below such a table: what its lines mean, and a warning where the seeds are too few to
/// tell anything.
std::string paired_note(const std::vector<PairedRow>& rows);

}  // namespace piae::report
