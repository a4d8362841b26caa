#include "diagnosis/cross_entropy.hpp"

#include <algorithm>
#include <cmath>

namespace piae::diagnosis {

namespace {

/// Writes exp(logit - greatest) into `scores` for each logit; returns the sum.
template <class T>
T exponentials(std::int64_t classes, const T* logits, T greatest, T* scores) {
  T sum = 0;
  for (std::int64_t c = 0; c < classes; ++c) {
    scores[c] = std::exp(logits[c] - greatest);
    sum += scores[c];
  }
  return sum;
}

}  // namespace

template <class T>
void softmax(std::int64_t classes, const T* logits, T* scores) {
  const T greatest = *std::max_element(logits, logits + classes);
  const T sum = exponentials(classes, logits, greatest, scores);
  for (std::int64_t c = 0; c < classes; ++c) scores[c] /= sum;
}

template <class T>
BatchOutcome cross_entropy(std::int64_t classes, std::int64_t row, std::span<const Label> labels,
                           const T* logits, T* gradient) {
  BatchOutcome outcome;
  const auto windows = static_cast<T>(labels.size());
  for (const Label label : labels) {
    const T* greatest = std::max_element(logits, logits + classes);
    const T sum = exponentials(classes, logits, *greatest, gradient);
    outcome.loss += static_cast<double>(std::log(sum) + *greatest - logits[label]);
    if (greatest - logits == label) ++outcome.correct;
    for (std::int64_t c = 0; c < classes; ++c) gradient[c] /= sum * windows;
    gradient[label] -= 1 / windows;
    std::fill(gradient + classes, gradient + row, T{0});
    logits += row;
    gradient += row;
  }
  return outcome;
}

template void softmax(std::int64_t, const float*, float*);
template void softmax(std::int64_t, const double*, double*);
template BatchOutcome cross_entropy(std::int64_t, std::int64_t, std::span<const Label>,
                                    const float*, float*);
template BatchOutcome cross_entropy(std::int64_t, std::int64_t, std::span<const Label>,
                                    const double*, double*);

}  // namespace piae::diagnosis
