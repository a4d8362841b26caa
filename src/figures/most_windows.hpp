#pragma once

#include <string>
#include <vector>

#include "figures/source.hpp"

namespace piae::figures {

/// Diagnoses of one method at its ratio with the most generated windows.
struct MethodDiagnoses {
  run::Combination cell;  ///< the method, at its ratio with the most generated windows
  std::vector<scoring::DiagnosisRecord> seeds;

  [[nodiscard]] const signal::DatasetInfo& info() const { return seeds.front().info; }
  /// Returns the sum over the windows of all seeds.
  [[nodiscard]] scoring::Confusion confusion() const;
  /// Returns the first fields of a row: the method, 1 for a ceiling or else 0, and the ratio.
  [[nodiscard]] std::vector<std::string> fields() const;
};

/// Returns the diagnoses of each method, in the order of the grid, including `none`, which has only
/// one ratio. Throws LeftOut without any cell, Error for a missing or refused cell, and
/// Error(bad_input) for a cell whose classes or protocol differ from those before.
std::vector<MethodDiagnoses> diagnoses_with_most_windows(const Source& source);

}  // namespace piae::figures
