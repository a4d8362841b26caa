#include "nets/position_dense.hpp"

#include "base/vector.hpp"

namespace piae::nets {

ParameterSpec unbiased_dense_spec(const std::string& name, std::int64_t inputs,
                                  std::int64_t outputs) {
  return dense_specs(name, inputs, outputs).front();
}

template <class T>
PositionDense<T>::PositionDense(GradientArray<T>& parameters, const std::string& name,
                                std::int64_t length, Bias bias)
    : SequenceLayer<T>(
          {.length = length, .width = parameters.find(name + "/weight").held_columns},
          {.length = length, .width = whole_rows(parameters.find(name + "/weight").rows)}),
      products_(parameters.find(name + "/weight")) {
  if (bias == Bias::there) bias_ = parameters.find(name + "/bias");
}

template <class T>
void PositionDense<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t rows = windows * this->input().length;
  const std::int64_t width = this->output().width;
  products_.renew();
  products_.forward(rows, {x, this->input().width}, {y, width});
  if (bias_) add_bias(*bias_, rows, width, y);
}

template <class T>
void PositionDense<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  const std::int64_t rows = batch.windows * this->input().length;
  const std::int64_t inputs = this->input().width;
  const std::int64_t outputs = this->output().width;
  products_.differentiate(rows, {x, inputs}, {dy, outputs});
  if (bias_) differentiate_bias(*bias_, rows, outputs, dy);
  if (dx != nullptr) products_.backward(batch.signals * rows, {dy, outputs}, {dx, inputs});
}

template class PositionDense<float>;
template class PositionDense<double>;

}  // namespace piae::nets
