#include "nets/weight_products.hpp"

#include <algorithm>

#include "base/vector.hpp"
#include "nets/matrix_product.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

template <class T>
WeightProducts<T>::WeightProducts(const TrainedParameter<T>& weight)
    : weight_(weight),
      held_outputs_(whole_rows(weight.rows)),
      transposed_(Eigen::ArrayX<T>::Zero(weight.columns * held_outputs_)) {}

template <class T>
void WeightProducts<T>::renew() {
  // Process this many rows at a time, so that whole cache lines are written.
  for (std::int64_t first = 0; first < weight_.rows; first += row_granule) {
    const std::int64_t some = std::min(row_granule, weight_.rows - first);
    const T* const from = weight_.values + first * weight_.held_columns;
    for (std::int64_t i = 0; i < weight_.columns; ++i) {
      T* const to = transposed_.data() + i * held_outputs_ + first;
      for (std::int64_t j = 0; j < some; ++j) to[j] = from[j * weight_.held_columns + i];
    }
  }
}

template <class T>
void WeightProducts<T>::forward(std::int64_t rows, Rows<const T> x, Rows<T> y) const {
  multiply<T>({.a = x.data,
               .a_row = x.stride,
               .a_column = 1,
               .b = transposed_.data(),
               .b_row = held_outputs_,
               .c = y.data,
               .c_row = y.stride,
               .rows = rows,
               .columns = held_outputs_,
               .depth = weight_.columns});
}

template <class T>
void WeightProducts<T>::differentiate(std::int64_t rows, Rows<const T> x, Rows<const T> dy) const {
  multiply<T>({.a = dy.data,
               .a_row = 1,
               .a_column = dy.stride,
               .b = x.data,
               .b_row = x.stride,
               .c = weight_.gradient,
               .c_row = weight_.held_columns,
               .rows = weight_.rows,
               .columns = weight_.held_columns,
               .depth = rows});
}

template <class T>
void WeightProducts<T>::backward(std::int64_t rows, Rows<const T> dy, Rows<T> dx, bool add) const {
  multiply<T>({.a = dy.data,
               .a_row = dy.stride,
               .a_column = 1,
               .b = weight_.values,
               .b_row = weight_.held_columns,
               .c = dx.data,
               .c_row = dx.stride,
               .rows = rows,
               .columns = weight_.held_columns,
               .depth = weight_.rows,
               .add = add});
}

template <class T>
void add_bias(const TrainedParameter<T>& bias, std::int64_t rows, std::int64_t width, T* y) {
  as_matrix(y, rows, width).rowwise() += as_matrix(bias.values, 1, width).row(0);
}

template <class T>
void differentiate_bias(const TrainedParameter<T>& bias, std::int64_t rows, std::int64_t width,
                        const T* dy) {
  as_matrix(bias.gradient, 1, width) = as_matrix(dy, rows, width).colwise().sum();
}

template class WeightProducts<float>;
template class WeightProducts<double>;
template void add_bias(const TrainedParameter<float>&, std::int64_t, std::int64_t, float*);
template void add_bias(const TrainedParameter<double>&, std::int64_t, std::int64_t, double*);
template void differentiate_bias(const TrainedParameter<float>&, std::int64_t, std::int64_t,
                                 const float*);
template void differentiate_bias(const TrainedParameter<double>&, std::int64_t, std::int64_t,
                                 const double*);

}  // namespace piae::nets
