#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "regression/measurements.hpp"
#include "run/selection.hpp"

namespace piae::regression {

/// Required agreement of a run with its reference.
enum class Tolerance {
  /// Every seed has the same number, to 4 units in the last place. Possible only with the same
  /// processor, threads, compiler and libraries.
  exact,
  /// The means over the seeds differ by no more than chance explains. Other machines cannot agree
  /// better, because training amplifies a difference in the last digit to a different, equally good
  /// result.
  spread
};

/// Returns exact if both sides were made with the same single set of settings; else spread.
Tolerance tolerance_for(const Measurements& reference, const Measurements& run);

/// A quantity of one method, classifier and ratio, over the seeds that run and reference share.
struct DeviationRow {
  std::string method;
  std::string classifier;
  std::string ratio;
  std::string quantity;
  std::size_t seeds = 0;
  /// Number of seeds whose numbers differ by more than 4 units in the last place.
  std::size_t moved_seeds = 0;
  double reference = 0;  ///< mean over the seeds
  double run = 0;        ///< mean over the seeds
  /// Standard error of the difference of the two means. Empty with a single seed, which does not
  /// show any scatter.
  std::optional<double> standard_error;
  /// Allowed difference in standard errors. Chance exceeds it once in 370 comparisons: 3 for many
  /// seeds, more for few (Student's t).
  double allowed = 0;
  bool within = true;  ///< true if the difference is within the tolerance

  [[nodiscard]] double difference() const { return run - reference; }
  /// Returns the difference in standard errors; infinite for a difference without scatter.
  [[nodiscard]] std::optional<double> standard_errors() const;
};

/// Deviations of a run from its reference on one data set.
struct Deviations {
  std::vector<DeviationRow> rows;    ///< in the order of the reference
  std::vector<std::string> missing;  ///< cells in the reference only: "smote 10to1, seed 2"
  std::vector<std::string> not_in_reference;  ///< cells in the run only

  /// True if both have the same cells and all rows are within the tolerance.
  [[nodiscard]] bool acceptable() const;
};

/// Compares the selected cells of one data set over the seeds on both sides. The scatter of a
/// quantity comes from all its seeds, of run and reference, each about the mean of its side. Below
/// 8 degrees of freedom (five seeds on both sides have 8) this is too uncertain. Then the larger of
/// two variances is used, its own and that of all rows of the same quantity and classifier, with
/// the degrees of freedom of the latter. Throws std::logic_error if data set or protocol differ.
Deviations find_deviations(const Measurements& reference, const Measurements& run,
                           const run::Selection& selection, Tolerance tolerance);

}  // namespace piae::regression
