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
  std::string against;  ///< method that all others are compared with; empty if there is none
  std::vector<PairedRow> rows = {};  ///< by method, then ratio, then the mean of ratios
};

/// Compares all methods with `against`. `rows` are accuracy_rows() of one classifier. If `against`
/// is empty, uses this project's method if it has a row, else the paper's, else none. If faults are
/// known in other conditions than tested, this project's method that carries them there comes
/// first. `none` has one accuracy, which is compared at every ratio. Throws Error(usage) if
/// `against` has no row.
Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against);

/// The same for each classifier that has tables of its own. Leaves out classifiers that do not have
/// `against`, unless none has it.
std::vector<Comparisons> compare_by_classifier(const std::vector<AccuracyRow>& rows,
                                               const std::string& against);

/// Returns comparisons.csv: dataset,ratio,method,classifier,against and paired_columns(). The ratio
/// is "mean" for the mean of ratios.
std::string comparisons_csv(const std::vector<Comparisons>& comparisons);

/// Returns a section with a block for each method, or no section if there is nothing to compare.
std::vector<Section> comparison_sections(const Comparisons& comparisons);

}  // namespace piae::report
