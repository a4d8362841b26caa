#pragma once

#include <cstdint>
#include <span>

#include "base/label.hpp"

namespace piae::diagnosis {

/// What a batch gave, summed over its windows.
struct BatchOutcome {
  double loss = 0;  ///< cross-entropy
  /// Windows whose greatest logit is that of their label; of equal logits the first counts.
  std::int64_t correct = 0;
};

/// The softmax of `classes` logits, into as many scores.
template <class T>
void softmax(std::int64_t classes, const T* logits, T* scores);

/// The cross-entropy of logits, and in `gradient` the gradient of its mean over the windows by the
/// logits. Both arrays have a row of `row` numbers for each window. The first `classes` numbers of
/// a row count; the gradient by the others is set to 0.
template <class T>
BatchOutcome cross_entropy(std::int64_t classes, std::int64_t row, std::span<const Label> labels,
                           const T* logits, T* gradient);

}  // namespace piae::diagnosis
