#include "nets/joined_networks.hpp"

#include <algorithm>
#include <utility>

namespace piae::nets {

namespace {

/// Calls f(i, j) with the place i of each number of a matrix [height, width] and its place j in the
/// transposed one, square by square, so that neither is left for long.
template <class F>
void for_each_place(std::int64_t height, std::int64_t width, const F& f) {
  constexpr std::int64_t square = 16;
  for (std::int64_t top = 0; top < height; top += square) {
    for (std::int64_t left = 0; left < width; left += square) {
      for (std::int64_t y = top; y < std::min(top + square, height); ++y) {
        for (std::int64_t x = left; x < std::min(left + square, width); ++x) {
          f(y * width + x, x * height + y);
        }
      }
    }
  }
}

}  // namespace

template <class T>
JoinedNetworks<T>::JoinedNetworks(std::unique_ptr<Network<T>> first, std::int64_t height,
                                  std::int64_t width, std::unique_ptr<Network<T>> second)
    : first_(std::move(first)), height_(height), width_(width), second_(std::move(second)) {}

template <class T>
Rows<const T> JoinedNetworks<T>::forward(std::int64_t rows) {
  const Rows<const T> given = first_->forward(rows);
  for (std::int64_t r = 0; r < rows; ++r) {
    const T* const from = given.row(r);
    T* const to = second_->input().row(r);
    for_each_place(height_, width_,
                   [&](std::int64_t i, std::int64_t j) { to[j] = std::max(from[i], T{0}); });
  }
  return second_->forward(rows);
}

template <class T>
Rows<const T> JoinedNetworks<T>::backward(std::int64_t rows, std::int64_t signals,
                                          RowRange by_input) {
  const Rows<const T> gradients = second_->backward(rows, signals, {0, signals * rows});
  for (std::int64_t r = 0; r < signals * rows; ++r) {
    const T* const taken = second_->input().row(r % rows);
    const T* const from = gradients.row(r);
    T* const to = first_->output_gradient().row(r);
    for_each_place(height_, width_,
                   [&](std::int64_t i, std::int64_t j) { to[i] = taken[j] > 0 ? from[j] : T{0}; });
  }
  return first_->backward(rows, signals, by_input);
}

template <class T>
double JoinedNetworks<T>::squared_norm() const {
  return first_->squared_norm() + second_->squared_norm();
}

template <class T>
void JoinedNetworks<T>::take(const AdamStep& step, double scale) {
  first_->take(step, scale);
  second_->take(step, scale);
}

template class JoinedNetworks<float>;
template class JoinedNetworks<double>;

}  // namespace piae::nets
