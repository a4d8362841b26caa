#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"
#include "report/sweep.hpp"

namespace piae::report {

/// What a part of a method is worth: the method with one setting moved, at one ratio, against the
/// method as it is.
struct PartRow {
  SweepRow moved;
  /// Minus the method as it is, in points; empty for a setting that it has anyway, and without a
  /// seed in common.
  std::optional<PairedRow> difference;
};

/// The rows of a sweep (sweep_rows()), each beside that of the same ratio in which nothing is
/// moved.
std::vector<PartRow> part_rows(const std::vector<SweepRow>& rows);

/// sweep@METHOD.csv: dataset,method,classifier,factor,value,centre,ratio,seeds,mean,std,ci95_low,
/// ci95_high,pairs,difference,difference_std,difference_ci95_low,difference_ci95_high in percent
/// and points; `seeds` and `pairs` are how many there are. Of the method as it is, factor and value
/// are empty, and so is the difference; `centre` is 1 for a setting that it has anyway. Where kinds
/// of defects are told apart, the columns kind_mean,kind_std,kind_ci95_low,kind_ci95_high follow.
std::string parts_csv(const Sweep& sweep, const std::vector<PartRow>& rows);

/// The same for people: a table for each ratio. `rows` are at least one.
Document parts_document(const Sweep& sweep, const std::vector<PartRow>& rows,
                        const run::Results& results);

}  // namespace piae::report
