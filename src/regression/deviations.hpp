#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "regression/measurements.hpp"
#include "run/selection.hpp"

namespace piae::regression {

/// How near a run must come to its reference.
enum class Tolerance {
  /// Every seed's number is the same to 4 units in the last place. Right where processor, threads,
  /// compiler and libraries are the same.
  exact,
  /// The means over the seeds that are compared differ by no more than chance explains. Training
  /// magnifies a difference in the last digit into another, equally good result, so on another
  /// machine no more can be asked.
  spread
};

/// exact where both sides were made with one and the same settings, else spread.
Tolerance tolerance_for(const Measurements& reference, const Measurements& run);

/// A quantity of one method and ratio, over the seeds that both sides have.
struct DeviationRow {
  std::string method;
  std::string ratio;
  std::string quantity;
  std::size_t seeds = 0;
  std::size_t moved_seeds = 0;  ///< that are not the same to 4 units in the last place
  double reference = 0;         ///< mean
  double run = 0;               ///< mean
  /// Standard error of the difference of the two means; empty where no two seeds say how much they
  /// scatter.
  std::optional<double> standard_error;
  /// As many standard errors as chance alone exceeds once in 370 comparisons: 3 for many seeds,
  /// more for few (Student's t).
  double allowed = 0;
  bool within = true;  ///< the tolerance

  [[nodiscard]] double difference() const { return run - reference; }
  /// The difference in standard errors; infinite where it is not 0 and nothing scatters.
  [[nodiscard]] std::optional<double> standard_errors() const;
};

struct Deviations {
  std::vector<DeviationRow> rows;    ///< in the order of the reference
  std::vector<std::string> missing;  ///< "smote 10to1, seeds 2 3": in the reference only
  std::vector<std::string> not_in_reference;

  [[nodiscard]] bool passed() const;
};

/// Compares the selected cells of one dataset, seed by seed the same. The spread of a row is that
/// of all its seeds, on both sides, about the mean of their side. Where it has fewer than 8 degrees
/// of freedom (five seeds on both sides have 8), it is the larger of its own and that of all rows
/// of the same quantity together, and the degrees of freedom are those of all. Throws
/// std::logic_error for two datasets or protocols.
Deviations find_deviations(const Measurements& reference, const Measurements& run,
                           const run::Selection& selection, Tolerance tolerance);

}  // namespace piae::regression
