#pragma once

#include <string>
#include <vector>

#include "figures/source.hpp"

namespace piae::figures {

/// What the classifiers of one method said of the test windows, where most windows were generated.
struct MethodDiagnoses {
  run::Combination cell;  ///< the method, and of its ratios the one with the most generated windows
  std::vector<scoring::DiagnosisRecord> seeds;

  [[nodiscard]] const signal::DatasetInfo& info() const { return seeds.front().info; }
  /// Of the windows of all seeds together.
  [[nodiscard]] scoring::Confusion confusion() const;
  /// The first fields of a row: the method, 1 for a ceiling or else 0, and the ratio.
  [[nodiscard]] std::vector<std::string> fields() const;
};

/// Those of each method, in the order of the grid; `none`, which has but one ratio, is among them.
/// Throws LeftOut where there is no cell at all, Error for one that is missing or refused, and
/// Error(bad_input) for one that has other classes, or comes from another kind of split, than those
/// before it.
std::vector<MethodDiagnoses> diagnoses_with_most_windows(const Source& source);

}  // namespace piae::figures
