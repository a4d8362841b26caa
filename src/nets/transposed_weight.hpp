#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "nets/parameters.hpp"
#include "nets/row_product.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// The weight [outputs, inputs] of a layer in the order in which products with it read it forward:
/// [inputs, outputs], of which rows are filled up with zeros to whole vectors. It is turned anew
/// once a step.
template <class T>
class TransposedWeight {
 public:
  explicit TransposedWeight(const typename Parameters<T>::Parameter& weight);

  /// Takes over the weight as it is now. `weight` points to its first number.
  void renew(const T* weight);

  [[nodiscard]] std::int64_t held_outputs() const { return held_outputs_; }
  /// y = x W^T or y += x W^T for x [rows, inputs] and y [rows, held outputs].
  void set(Rows<const T> x, std::int64_t rows, Rows<T> y) const {
    set_product(product(x, rows, y));
  }
  void add(Rows<const T> x, std::int64_t rows, Rows<T> y) const {
    add_product(product(x, rows, y));
  }

 private:
  [[nodiscard]] RowProduct<T> product(Rows<const T> x, std::int64_t rows, Rows<T> y) const;

  std::int64_t inputs_;
  std::int64_t held_inputs_;
  std::int64_t outputs_;
  std::int64_t held_outputs_;
  Eigen::ArrayX<T> numbers_;
};

extern template class TransposedWeight<float>;
extern template class TransposedWeight<double>;

}  // namespace piae::nets
