#include "nets/weight_products.hpp"

#include "base/vector.hpp"
#include "nets/matrix_product.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

template <class T>
WeightProducts<T>::WeightProducts(const TrainedParameter<T>& weight)
    : weight_(weight),
      held_outputs_(whole_rows(weight.rows)),
      transposed_(Eigen::ArrayX<T>::Zero(weight.held_columns * held_outputs_)) {}

template <class T>
void WeightProducts<T>::forward(std::int64_t rows, const T* x, T* y) {
  as_matrix(transposed_.data(), weight_.held_columns, held_outputs_).leftCols(weight_.rows) =
      as_matrix(weight_.values, weight_.rows, weight_.held_columns).transpose();
  multiply<T>({.a = x,
               .a_row = weight_.held_columns,
               .a_column = 1,
               .a_block = 0,
               .b = transposed_.data(),
               .b_block = 0,
               .c = y,
               .rows = rows,
               .columns = held_outputs_,
               .depth = weight_.held_columns});
}

template <class T>
void WeightProducts<T>::differentiate(std::int64_t rows, const T* x, const T* dy) const {
  multiply<T>({.a = dy,
               .a_row = 1,
               .a_column = held_outputs_,
               .a_block = 0,
               .b = x,
               .b_block = 0,
               .c = weight_.gradient,
               .rows = weight_.rows,
               .columns = weight_.held_columns,
               .depth = rows});
}

template <class T>
void WeightProducts<T>::backward(std::int64_t rows, const T* dy, T* dx) const {
  multiply<T>({.a = dy,
               .a_row = held_outputs_,
               .a_column = 1,
               .a_block = 0,
               .b = weight_.values,
               .b_block = 0,
               .c = dx,
               .rows = rows,
               .columns = weight_.held_columns,
               .depth = weight_.rows});
}

template class WeightProducts<float>;
template class WeightProducts<double>;

}  // namespace piae::nets
