#include "nets/joined_networks.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace piae::nets {

namespace {

/// Writes a matrix [height, width] transposed, square by square, so that neither is left for long.
template <class T>
void transpose(std::int64_t height, std::int64_t width, const T* from, T* to) {
  constexpr std::int64_t square = 16;
  for (std::int64_t top = 0; top < height; top += square) {
    for (std::int64_t left = 0; left < width; left += square) {
      for (std::int64_t y = top; y < std::min(top + square, height); ++y) {
        for (std::int64_t x = left; x < std::min(left + square, width); ++x) {
          to[x * height + y] = from[y * width + x];
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
    T* const to = second_->input().row(r);
    transpose(height_, width_, given.row(r), to);
    for (std::int64_t i = 0; i < height_ * width_; ++i) to[i] = std::max(to[i], T{0});
  }
  return second_->forward(rows);
}

template <class T>
Rows<const T> JoinedNetworks<T>::backward(std::int64_t rows, std::int64_t signals,
                                          RowRange by_input) {
  const Rows<const T> gradients = second_->backward(rows, signals, {0, signals * rows});
  std::vector<T> passed(static_cast<std::size_t>(height_ * width_));
  for (std::int64_t r = 0; r < signals * rows; ++r) {
    const T* const taken = second_->input().row(r % rows);
    const T* const gradient = gradients.row(r);
    for (std::size_t i = 0; i < passed.size(); ++i) passed[i] = taken[i] > 0 ? gradient[i] : T{0};
    transpose<T>(width_, height_, passed.data(), first_->output_gradient().row(r));
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
