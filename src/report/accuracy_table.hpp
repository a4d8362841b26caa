#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

/// Returns accuracy.csv and gains.csv: dataset,method,classifier,ratio and the fields of
/// accuracy_columns(): generated_per_class,seeds,mean,std,ci95_low,ci95_high,published in percent
/// or points. `seeds` is their number. Empty are the standard deviation of a single seed, intervals
/// that tables do not show (report/accuracies.hpp), and numbers that are not published for this
/// data set. Data sets with fault types add kind_mean,kind_std,kind_ci95_low,kind_ci95_high.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// Returns the accuracies for a terminal, at most 100 columns wide: a table for each classifier.
std::string accuracy_text(const std::vector<AccuracyRow>& rows);

/// Style of a table of methods by ratios.
struct MatrixStyle {
  bool short_ratios = false;       ///< "2:1" instead of "2:1 (3.33:1)"
  bool marks_fewer_seeds = false;  ///< after the names of methods
  std::function<text::Cell(const AccuracyRow&)> cell_of;
};

/// Returns a table with a method in each row and a ratio in each column; `reference_row` follows if
/// known.
text::Table ratio_matrix(const std::vector<AccuracyRow>& rows,
                         const std::optional<AccuracyRow>& reference_row, const MatrixStyle& style);

/// Returns the means of all methods side by side. Tables 6 to 11 of the paper and the gains of its
/// Figs 15 and 18 follow, with the published numbers next to ours. Other data sets get the same
/// tables. The first of them is without generated windows and has a run in each row. The tables of
/// compared methods and of ablations have a block for each method, with a row for each ratio. Empty
/// tables are left out. Every table of accuracies includes the reference if it is known.
std::vector<Section> accuracy_sections(const ClassifierRows& of_classifier,
                                       const Published& published);

/// Returns for a page the accuracies of one classifier and, if there are any, the gains over none:
/// a method in each row, a ratio in each column. A cell has all accuracy_columns(), and the number
/// of its seeds if that is less than `seeds`.
std::vector<Section> ratio_sections(const ClassifierRows& block, std::size_t seeds);

}  // namespace piae::report
