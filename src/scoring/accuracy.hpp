#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// Counts how often windows of each class were predicted as each class: a row for each true class,
/// a column for each predicted one.
struct Confusion {
  std::size_t classes = 0;           ///< C
  std::vector<std::int64_t> counts;  ///< row-major [C, C]

  [[nodiscard]] std::int64_t at(std::size_t truth, std::size_t predicted) const {
    return counts[truth * classes + predicted];
  }
  bool operator==(const Confusion&) const = default;
};

/// Adds `confusion` to `sum`, which may be empty. Both have the same classes.
void add(Confusion& sum, const Confusion& confusion);

/// Counts labels and predictions, [n] each, with values in {0, ..., classes - 1}. Throws
/// std::logic_error if their lengths differ or a value is not a class.
Confusion confusion_matrix(std::span<const Label> labels, std::span<const Label> predictions,
                           std::size_t classes);

/// Returns the share of windows classified correctly, in [0, 1] (paper, eq. 29). Throws
/// std::logic_error without windows.
double accuracy(const Confusion& confusion);

/// Returns the mean over the classes of the share of their windows classified correctly, in [0, 1];
/// a class without windows does not count. Throws std::logic_error without windows.
double balanced_accuracy(const Confusion& confusion);

}  // namespace piae::scoring
