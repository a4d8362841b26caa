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
  /// The number of every seed is the same, to 4 units in the last place. This can be asked where
  /// processor, threads, compiler and libraries are the same.
  exact,
  /// The means over the seeds differ by no more than chance explains. On another machine no more
  /// can
  /// be asked, because training magnifies a difference in the last digit into another result that
  /// is
  /// equally good.
  spread
};

/// exact where both sides were made with the same settings, and with these alone; else spread.
Tolerance tolerance_for(const Measurements& reference, const Measurements& run);

/// A quantity of one method, classifier and ratio, over the seeds that both run and reference have.
struct DeviationRow {
  std::string method;
  std::string classifier;
  std::string ratio;
  std::string quantity;
  std::size_t seeds = 0;
  /// Those whose numbers are not the same to 4 units in the last place.
  std::size_t moved_seeds = 0;
  double reference = 0;  ///< mean over the seeds
  double run = 0;        ///< mean over the seeds
  /// Standard error of the difference of the two means. Empty where there is one seed alone, which
  /// does not say how much seeds scatter.
  std::optional<double> standard_error;
  /// How many standard errors the difference may have: as many as chance alone exceeds once in 370
  /// comparisons, which is 3 for many seeds and more for few (Student's t).
  double allowed = 0;
  bool within = true;  ///< whether the difference is within the tolerance

  [[nodiscard]] double difference() const { return run - reference; }
  /// The difference in standard errors; infinite where there is a difference and no scatter.
  [[nodiscard]] std::optional<double> standard_errors() const;
};

/// How a run deviates from its reference on one dataset.
struct Deviations {
  std::vector<DeviationRow> rows;    ///< in the order of the reference
  std::vector<std::string> missing;  ///< cells of the reference alone: "smote 10to1, seed 2"
  std::vector<std::string> not_in_reference;  ///< cells of the run alone

  /// Whether both have the same cells, and all rows are within the tolerance.
  [[nodiscard]] bool acceptable() const;
};

/// Compares the selected cells of one dataset; the same seeds on both sides. How much a quantity
/// scatters comes from all of its seeds, of run and of reference, each about the mean of its side.
/// With less than 8 degrees of freedom (five seeds on both sides have 8) that is too uncertain:
/// then the larger of two variances is taken, its own and that of all rows of the same quantity and
/// classifier together, with the degrees of freedom of the latter. Throws std::logic_error for two
/// datasets or protocols.
Deviations find_deviations(const Measurements& reference, const Measurements& run,
                           const run::Selection& selection, Tolerance tolerance);

}  // namespace piae::regression
