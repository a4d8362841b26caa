#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

/// accuracy.csv and gains.csv: dataset,method,classifier,ratio and the fields of
/// accuracy_columns(): generated_per_class,seeds,mean,std,ci95_low,ci95_high,published in percent
/// or points; `seeds` is how many there are. Empty are the standard deviation of a single seed, an
/// interval that no table shows (report/accuracies.hpp), and what the paper does not publish
/// of this very dataset. Where kinds of defects are told apart, the columns
/// kind_mean,kind_std,kind_ci95_low,kind_ci95_high follow.
std::string accuracy_csv(const std::vector<AccuracyRow>& rows);

/// The accuracies for a terminal, at most 100 columns wide: a table for each classifier.
std::string accuracy_text(const std::vector<AccuracyRow>& rows);

/// How a table of methods by ratios is made.
struct MatrixStyle {
  bool short_ratios = false;       ///< "2:1" instead of "2:1 (3.33:1)"
  bool marks_fewer_seeds = false;  ///< behind the names of methods
  std::function<text::Cell(const AccuracyRow&)> cell_of;
};

/// A method in each row, a ratio in each column; then the bar, where it is known.
text::Table ratio_matrix(const std::vector<AccuracyRow>& rows,
                         const std::optional<AccuracyRow>& bar, const MatrixStyle& style);

/// The means of all methods side by side; then Tables 6 to 11 of the paper and the gains that it
/// draws in Figs 15 and 18, or the same for another dataset, with the published numbers beside
/// ours. Of these the first is without generated windows and has a run in each row. Accuracies and
/// gains of the compared methods, and those of the ablations, have a block for each method, in
/// which each ratio has a row. Tables without a row are left out. Every table of
/// accuracies has the bar, too, where it is known.
std::vector<Section> accuracy_sections(const ClassifierRows& of_classifier,
                                       const Published& published);

/// For a page: the accuracies of one classifier, and the gains over none where there are any, each
/// as a method in each row and a ratio in each column. A cell has all accuracy_columns(), and says
/// of how many of the grid's `seeds` it is where that is not all.
std::vector<Section> ratio_sections(const ClassifierRows& block, std::size_t seeds);

}  // namespace piae::report
