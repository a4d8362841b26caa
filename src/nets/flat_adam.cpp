#include "nets/flat_adam.hpp"

#include <cmath>

namespace piae::nets {

template <class T>
void FlatAdam<T>::step(T* values, const T* gradients, double learning_rate) {
  ++steps_;
  const auto t = static_cast<double>(steps_);
  constexpr auto beta1 = static_cast<T>(AdamConstants::beta1);
  constexpr auto beta2 = static_cast<T>(AdamConstants::beta2);
  constexpr auto newest1 = static_cast<T>(1 - AdamConstants::beta1);
  constexpr auto newest2 = static_cast<T>(1 - AdamConstants::beta2);
  constexpr auto epsilon = static_cast<T>(AdamConstants::epsilon);
  const auto correction = static_cast<T>(1 / std::sqrt(1 - std::pow(AdamConstants::beta2, t)));
  const auto rate = static_cast<T>(learning_rate / (1 - std::pow(AdamConstants::beta1, t)));
  T* const first = first_moment_.data();
  T* const second = second_moment_.data();
  const std::size_t size = first_moment_.size();
  for (std::size_t i = 0; i < size; ++i) {
    const T gradient = gradients[i];
    first[i] = beta1 * first[i] + newest1 * gradient;
    second[i] = beta2 * second[i] + newest2 * gradient * gradient;
    values[i] -= rate * first[i] / (std::sqrt(second[i]) * correction + epsilon);
  }
}

template class FlatAdam<float>;
template class FlatAdam<double>;

}  // namespace piae::nets
