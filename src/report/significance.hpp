#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"

namespace piae::report {

/// All methods of a grid against one of them.
struct Comparisons {
  std::string dataset;
  std::string against;          ///< empty where there is none to compare with
  std::vector<PairedRow> rows;  ///< of all others, by method, then ratio, then the mean of ratios
};

/// `rows` are of accuracy_rows. `against`: the method to compare with; empty for piae-dt-phase
/// where it has a row, else piae-dt, else nothing. `none`, which has no ratio but its own, stands
/// for every ratio. Throws Error(usage) for a method that has no row.
Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against);

/// comparisons.csv: dataset,ratio,method,against and those of paired_header(); the ratio is "mean"
/// in the mean of ratios.
std::string comparisons_csv(const Comparisons& comparisons);

/// One section with a method in up to four lines and a ratio a column; none without comparisons.
std::vector<Section> comparison_sections(const Comparisons& comparisons,
                                         const std::vector<AccuracyRow>& rows);

}  // namespace piae::report
