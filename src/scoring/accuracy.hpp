#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// How often windows of each class were taken for each other class: a row for each true class, a
/// column for each predicted one.
struct Confusion {
  std::size_t classes = 0;           ///< C
  std::vector<std::int64_t> counts;  ///< row-major [C, C]

  [[nodiscard]] std::int64_t at(std::size_t truth, std::size_t predicted) const {
    return counts[truth * classes + predicted];
  }
  bool operator==(const Confusion&) const = default;
};

/// Adds the counts of another to a sum, which may be empty as yet. Both are of the same classes.
void add(Confusion& sum, const Confusion& confusion);

/// labels and predictions are [n], each in {0, ..., classes - 1}. Throws std::logic_error when they
/// differ in length, and when one of them is no class.
Confusion confusion_matrix(std::span<const Label> labels, std::span<const Label> predictions,
                           std::size_t classes);

/// Share of windows that were recognised, in [0, 1] (paper, eq. 29). Throws std::logic_error when
/// there is not one window.
double accuracy(const Confusion& confusion);

/// The mean over the classes of the share of their windows that were recognised, in [0, 1]; a class
/// without a window does not count. Throws std::logic_error when there is not one window.
double balanced_accuracy(const Confusion& confusion);

}  // namespace piae::scoring
