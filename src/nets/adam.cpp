#include "nets/adam.hpp"

#include <cmath>

#include "base/denormals.hpp"

namespace piae::nets {

AdamStep::AdamStep(std::int64_t t, double learning_rate, double beta1, double beta2)
    : beta1(beta1),
      beta2(beta2),
      rate(learning_rate / (1 - std::pow(beta1, static_cast<double>(t)))),
      correction(1 / std::sqrt(1 - std::pow(beta2, static_cast<double>(t)))) {}

template <class T>
void take(const AdamStep& step, T* values, const T* gradients, T* first_moment, T* second_moment,
          std::size_t size) {
  // If a weight no longer gets a gradient, its first moment decays and stays denormal for the rest
  // of the training. Steps that small do not move the weight.
  const DenormalsAreZero guard;
  const AdamUpdate<T> update(step);
  for (std::size_t i = 0; i < size; ++i) {
    update(gradients[i], values[i], first_moment[i], second_moment[i]);
  }
}

template void take(const AdamStep&, float*, const float*, float*, float*, std::size_t);
template void take(const AdamStep&, double*, const double*, double*, double*, std::size_t);

template <class T>
void Adam<T>::step(T* values, const T* gradients, double learning_rate) {
  const AdamStep step(++steps_, learning_rate);
  take(step, values, gradients, first_moment_.data(), second_moment_.data(), first_moment_.size());
}

template class Adam<float>;
template class Adam<double>;

}  // namespace piae::nets
