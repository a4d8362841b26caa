#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"

namespace piae::report {

/// All methods of a grid compared with one of them, by one classifier.
struct Comparisons {
  std::string dataset;
  std::string classifier;
  std::string against;  ///< the one that all are compared with; empty where there is none
  std::vector<PairedRow> rows = {};  ///< by method, then ratio, then the mean of ratios
};

/// `rows` are of accuracy_rows() and of one classifier. `against` is the method that all others are
/// compared with. Where it is empty, that is this project's method if it has a row (where faults
/// are known in other conditions than tested, first the one that carries them there), else the
/// paper's, else none. `none` has one accuracy, with which methods are compared at every ratio.
/// Throws Error(usage) for a method that has no row.
Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against);

/// The same for each classifier that has tables of its own. One that does not have `against` has no
/// rows, unless none has it.
std::vector<Comparisons> compare_by_classifier(const std::vector<AccuracyRow>& rows,
                                               const std::string& against);

/// comparisons.csv: dataset,ratio,method,classifier,against and paired_columns(). The ratio is
/// "mean" for the mean of ratios.
std::string comparisons_csv(const std::vector<Comparisons>& comparisons);

/// One section with a block for each method. No section where there is nothing to compare.
std::vector<Section> comparison_sections(const Comparisons& comparisons);

}  // namespace piae::report
