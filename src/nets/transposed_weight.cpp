#include "nets/transposed_weight.hpp"

#include <algorithm>

#include "base/vector.hpp"

namespace piae::nets {

template <class T>
TransposedWeight<T>::TransposedWeight(const typename Parameters<T>::Parameter& weight)
    : inputs_(weight.columns),
      held_inputs_(weight.held_columns),
      outputs_(weight.rows),
      held_outputs_(whole_rows(weight.rows)),
      numbers_(Eigen::ArrayX<T>::Zero(inputs_ * held_outputs_)) {}

template <class T>
void TransposedWeight<T>::renew(const T* weight) {
  // So many rows side by side, so that whole lines of memory are written.
  for (std::int64_t first = 0; first < outputs_; first += row_granule) {
    const std::int64_t some = std::min(row_granule, outputs_ - first);
    const T* const from = weight + first * held_inputs_;
    for (std::int64_t i = 0; i < inputs_; ++i) {
      T* const to = numbers_.data() + i * held_outputs_ + first;
      for (std::int64_t j = 0; j < some; ++j) to[j] = from[j * held_inputs_ + i];
    }
  }
}

template <class T>
RowProduct<T> TransposedWeight<T>::product(Rows<const T> x, std::int64_t rows, Rows<T> y) const {
  return {.a = x.data,
          .a_row = x.stride,
          .a_column = 1,
          .b = numbers_.data(),
          .b_row = held_outputs_,
          .c = y.data,
          .c_row = y.stride,
          .rows = rows,
          .columns = held_outputs_,
          .depth = inputs_};
}

template class TransposedWeight<float>;
template class TransposedWeight<double>;

}  // namespace piae::nets
