#pragma once

#include <cstdint>
#include <span>

namespace piae::diagnosis {

/// Sums over a batch.
struct BatchOutcome {
  double loss = 0;  ///< cross-entropy
  std::int64_t correct =
      0;  ///< windows whose greatest logit, the first of equals, is their label's
};

/// Softmax of `classes` logits.
template <class T>
void softmax(std::int64_t classes, const T* logits, T* scores);

/// Cross-entropy of logits, whose rows are `row` numbers apart and of which the first `classes`
/// count, and the gradient of its mean over the windows by them, in rows alike: 0 for the others.
template <class T>
BatchOutcome cross_entropy(std::int64_t classes, std::int64_t row,
                           std::span<const std::int32_t> labels, const T* logits, T* gradient);

}  // namespace piae::diagnosis
