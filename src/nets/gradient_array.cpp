#include "nets/gradient_array.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace piae::nets {

template <class T>
GradientArray<T>::GradientArray(std::shared_ptr<Parameters<T>> parameters, std::string network)
    : parameters_(std::move(parameters)), network_(std::move(network)) {
  std::int64_t size = 0;
  for (const auto& parameter : parameters_->parameters()) {
    if (!parameter.spec.name.starts_with(network_ + "/")) continue;
    if (size == 0) begin_ = parameter.begin;
    if (parameter.begin != begin_ + size) {
      throw std::logic_error("parameters " + network_ + "/... are not contiguous");
    }
    size += parameter.rows * parameter.held_columns;
  }
  if (size == 0) throw std::logic_error("no parameter is called " + network_ + "/...");
  gradients_ = Eigen::ArrayX<T>::Zero(size);
}

template <class T>
TrainedParameter<T> GradientArray<T>::find(const std::string& name) {
  const auto& parameter = parameters_->find(network_ + "/" + name);
  return {.values = parameters_->data(Parameters<T>::Kept::value) + parameter.begin,
          .gradient = gradients_.data() + parameter.begin - begin_,
          .rows = parameter.rows,
          .columns = parameter.columns,
          .held_columns = parameter.held_columns};
}

template <class T>
double GradientArray<T>::squared_norm() const {
  // Single precision suffices for partial sums of this size.
  constexpr std::int64_t together = 4096;
  double sum = 0;
  for (std::int64_t i = 0; i < gradients_.size(); i += together) {
    sum += gradients_.segment(i, std::min(together, gradients_.size() - i)).square().sum();
  }
  return sum;
}

template <class T>
void GradientArray<T>::take(const AdamStep& step, double scale) {
  using Kept = typename Parameters<T>::Kept;
  gradients_ *= static_cast<T>(scale);
  nets::take(step, parameters_->data(Kept::value) + begin_, gradients_.data(),
             parameters_->data(Kept::first_moment) + begin_,
             parameters_->data(Kept::second_moment) + begin_,
             static_cast<std::size_t>(gradients_.size()));
}

template class GradientArray<float>;
template class GradientArray<double>;

}  // namespace piae::nets
