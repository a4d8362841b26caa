#pragma once

#include <cstdint>
#include <span>

#include "base/label.hpp"

namespace piae::diagnosis {

/// Result of a batch, summed over its windows.
struct BatchOutcome {
  double loss = 0;  ///< cross-entropy
  /// Windows whose greatest logit is that of their label; among equal logits the first counts.
  std::int64_t correct = 0;
};

/// Writes the softmax of `classes` logits into `scores`.
template <class T>
void softmax(std::int64_t classes, const T* logits, T* scores);

/// Returns the cross-entropy of logits, and writes the gradient of its mean over the windows with
/// respect to the logits. Both arrays have a row of `row` numbers for each window. Only the first
/// `classes` numbers of a row count; the gradient of the others is set to 0.
template <class T>
BatchOutcome cross_entropy(std::int64_t classes, std::int64_t row, std::span<const Label> labels,
                           const T* logits, T* gradient);

}  // namespace piae::diagnosis
