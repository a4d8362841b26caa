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
      weight_(parameters.find(name + "/weight")) {
  if (bias == Bias::there) bias_ = parameters.find(name + "/bias");
}

template <class T>
void PositionDense<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t rows = windows * this->input().length;
  const std::int64_t width = this->output().width;
  const auto weight = as_matrix(weight_.values, weight_.rows, weight_.held_columns);
  auto all = as_matrix(y, rows, width);
  if (bias_) {
    all.rowwise() = as_matrix(bias_->values, 1, width).row(0);  // filled up with zeros
  } else {
    all.setZero();
  }
  all.leftCols(weight_.rows).noalias() +=
      as_matrix(x, rows, weight_.held_columns) * weight.transpose();
}

template <class T>
void PositionDense<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  const std::int64_t rows = batch.windows * this->input().length;
  const std::int64_t width = this->output().width;
  const auto first = as_matrix(dy, rows, width);
  as_matrix(weight_.gradient, weight_.rows, weight_.held_columns).noalias() =
      first.leftCols(weight_.rows).transpose() * as_matrix(x, rows, weight_.held_columns);
  if (bias_) as_matrix(bias_->gradient, 1, width) = first.colwise().sum();
  if (dx == nullptr) return;
  const std::int64_t all_rows = batch.signals * rows;
  as_matrix(dx, all_rows, weight_.held_columns).noalias() =
      as_matrix(dy, all_rows, width).leftCols(weight_.rows) *
      as_matrix(weight_.values, weight_.rows, weight_.held_columns);
}

template class PositionDense<float>;
template class PositionDense<double>;

}  // namespace piae::nets
