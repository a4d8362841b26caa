#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"
#include "report/sweep.hpp"

namespace piae::report {

/// Effect of a part of a method: the method with one setting changed, at one ratio, compared with
/// the unchanged method.
struct PartRow {
  SweepRow moved;
  /// Difference from the unchanged method, in points. Empty for a setting that the method already
  /// has, and if no seed is in common.
  std::optional<PairedRow> difference;
};

/// Returns the rows of a sweep (sweep_rows()), each with its difference from the unchanged method
/// at the same ratio.
std::vector<PartRow> part_rows(const std::vector<SweepRow>& rows);

/// Returns sweep@METHOD.csv:
/// dataset,method,classifier,factor,value,centre,ratio,seeds,mean,std,ci95_low,
/// ci95_high,pairs,difference,difference_std,difference_ci95_low,difference_ci95_high in percent
/// and points. `seeds` and `pairs` are numbers of seeds. Factor, value and difference are empty for
/// the unchanged method; `centre` is 1 for a setting that it already has. Datasets with fault types
/// add kind_mean,kind_std,kind_ci95_low,kind_ci95_high.
std::string parts_csv(const Sweep& sweep, const std::vector<PartRow>& rows);

/// Returns the same for people: a table for each ratio. Expects at least one row.
Document parts_document(const Sweep& sweep, const std::vector<PartRow>& rows,
                        const run::Results& results);

}  // namespace piae::report
