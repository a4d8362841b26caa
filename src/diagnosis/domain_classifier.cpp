#include "diagnosis/domain_classifier.hpp"

#include <cmath>
#include <utility>

#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::diagnosis {

namespace {

/// Returns the binary cross-entropy of a logit, and writes its derivative.
template <class T>
double binary_cross_entropy(T logit, bool is_labelled, T& derivative) {
  const T odds = std::exp(-std::abs(logit));  // never overflows
  const T probability = (logit > 0 ? T{1} : odds) / (1 + odds);
  derivative = probability - (is_labelled ? T{1} : T{0});
  return static_cast<double>(std::log1p(odds) + (is_labelled == (logit > 0) ? 0 : std::abs(logit)));
}

}  // namespace

template <class T>
DomainClassifier<T>::DomainClassifier(Adaptation adaptation, std::int64_t classes,
                                      std::int64_t most_windows, const Stream& initial)
    : classes_(adaptation == Adaptation::conditional ? classes : 0),
      parameters_(std::make_shared<nets::Parameters<T>>(
          nets::dense_chain_specs("domain",
                                  WdcnnLayers::hidden * std::max<std::int64_t>(classes_, 1), 1,
                                  {.depth = 2, .width = units}),
          initial)),
      chain_(parameters_, "domain", most_windows) {}

template <class T>
std::vector<T> DomainClassifier<T>::weights_of(const Batch& batch, std::int64_t window) const {
  if (classes_ == 0) return {1};
  std::vector<T> probabilities(static_cast<std::size_t>(classes_));
  softmax(classes_, batch.logits.row(window), probabilities.data());
  return probabilities;
}

template <class T>
double DomainClassifier<T>::step(const Batch& batch, double learning_rate, double reversal,
                                 nets::Rows<T> gradient) {
  constexpr std::int64_t hidden = WdcnnLayers::hidden;
  const auto windows = static_cast<T>(batch.windows);
  std::vector<std::vector<T>> weights;
  for (std::int64_t i = 0; i < batch.windows; ++i) {
    weights.push_back(weights_of(batch, i));
    T* to = chain_.input().row(i);
    for (const T weight : weights.back()) {
      for (std::int64_t j = 0; j < hidden; ++j) *to++ = weight * batch.hidden.row(i)[j];
    }
  }
  const nets::Rows<const T> logits = chain_.forward(batch.windows);
  double loss = 0;
  for (std::int64_t i = 0; i < batch.windows; ++i) {
    T& derivative = *chain_.output_gradient().row(i);
    loss += binary_cross_entropy(*logits.row(i), i < batch.labelled, derivative);
    derivative /= windows;
  }
  const nets::Rows<const T> by_input =
      chain_.backward_and_take(nets::AdamStep(++steps_, learning_rate), /*by_input=*/true);
  for (std::int64_t i = 0; i < batch.windows; ++i) {
    T* const to = gradient.row(i);
    std::fill_n(to, hidden, T{0});
    const T* from = by_input.row(i);
    for (const T weight : weights[static_cast<std::size_t>(i)]) {
      for (std::int64_t j = 0; j < hidden; ++j) {
        to[j] -= static_cast<T>(reversal) * weight * *from++;
      }
    }
  }
  return loss / static_cast<double>(batch.windows);
}

template class DomainClassifier<float>;
template class DomainClassifier<double>;

}  // namespace piae::diagnosis
