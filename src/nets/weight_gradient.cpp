#include "nets/weight_gradient.hpp"

#include <algorithm>

#include "nets/row_product.hpp"

namespace piae::nets {

template <class T>
void set_weight_gradient(Rows<const T> dy, Rows<const T> x, std::int64_t rows, std::int64_t outputs,
                         std::int64_t held_inputs, T* gradient) {
  set_product<T>({.a = dy.data,
                  .a_row = 1,
                  .a_column = dy.stride,
                  .b = x.data,
                  .b_row = x.stride,
                  .c = gradient,
                  .c_row = held_inputs,
                  .rows = outputs,
                  .columns = held_inputs,
                  .depth = rows});
}

template <class T>
void set_bias_gradient(Rows<const T> dy, std::int64_t rows, std::int64_t outputs, T* gradient) {
  std::fill_n(gradient, outputs, T{0});
  for (std::int64_t i = 0; i < rows; ++i) {
    const T* const row = dy.row(i);
#pragma GCC ivdep
    for (std::int64_t j = 0; j < outputs; ++j) gradient[j] += row[j];
  }
}

template void set_weight_gradient(Rows<const float>, Rows<const float>, std::int64_t, std::int64_t,
                                  std::int64_t, float*);
template void set_weight_gradient(Rows<const double>, Rows<const double>, std::int64_t,
                                  std::int64_t, std::int64_t, double*);
template void set_bias_gradient(Rows<const float>, std::int64_t, std::int64_t, float*);
template void set_bias_gradient(Rows<const double>, std::int64_t, std::int64_t, double*);

}  // namespace piae::nets
