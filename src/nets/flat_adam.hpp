#pragma once

#include <cstdint>
#include <vector>

namespace piae::nets {

/// Of Adam, as Kingma and Ba recommend.
struct AdamConstants {
  static constexpr double beta1 = 0.9;
  static constexpr double beta2 = 0.999;
  static constexpr double epsilon = 1e-8;
};

/// Adam (Kingma and Ba 2015, Algorithm 1) over plain numbers, in one pass: what nets::Adam does
/// with tensors.
template <class T>
class FlatAdam {
 public:
  explicit FlatAdam(std::size_t size) : first_moment_(size), second_moment_(size) {}

  /// Both arrays have the `size` of the constructor.
  void step(T* values, const T* gradients, double learning_rate);

 private:
  std::vector<T> first_moment_;
  std::vector<T> second_moment_;
  std::int64_t steps_ = 0;
};

extern template class FlatAdam<float>;
extern template class FlatAdam<double>;

}  // namespace piae::nets
