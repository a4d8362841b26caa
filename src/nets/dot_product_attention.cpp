#include "nets/dot_product_attention.hpp"

#include <cmath>
#include <stdexcept>

#include "base/vector.hpp"

namespace piae::nets {

namespace {

/// Replaces each row by the softmax of `factor` times the row. Subtracts the largest number first,
/// so that no exponential overflows.
template <class T>
void softmax_rows(Eigen::Ref<RowMatrix<T>> scores, T factor) {
  for (std::int64_t i = 0; i < scores.rows(); ++i) {
    auto row = scores.row(i).array();
    row = (factor * (row - row.maxCoeff())).exp();
    row *= 1 / row.sum();
  }
}

}  // namespace

template <class T>
DotProductAttention<T>::DotProductAttention(const SequenceShape& output, std::int64_t heads)
    : SequenceLayer<T>({.length = output.length, .width = 3 * output.width}, output),
      heads_(heads),
      head_(output.width / heads),
      held_length_(whole_rows(output.length)),
      factor_(1 / std::sqrt(static_cast<T>(head_))),
      by_attention_(output.length, output.length) {
  if (head_ * heads != output.width) {
    throw std::logic_error("the number of attention heads does not divide the width");
  }
}

template <class T>
void DotProductAttention<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t length = this->output().length;
  const std::int64_t width = this->output().width;
  T* attention = room_for(windows * heads_ * length * held_length_, attention_);
  for (std::int64_t w = 0; w < windows; ++w) {
    const auto from = as_matrix(x + w * this->input().size(), length, 3 * width);
    auto to = as_matrix(y + w * this->output().size(), length, width);
    for (std::int64_t h = 0; h < heads_; ++h, attention += length * held_length_) {
      const auto queries = from.middleCols(h * head_, head_);
      const auto keys = from.middleCols(width + h * head_, head_);
      const auto values = from.middleCols(2 * width + h * head_, head_);
      auto scores = as_matrix(attention, length, held_length_).leftCols(length);
      scores.noalias() = queries * keys.transpose();
      softmax_rows<T>(scores, factor_);
      to.middleCols(h * head_, head_).noalias() = scores * values;
    }
  }
}

template <class T>
void DotProductAttention<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  if (dx == nullptr) return;
  const std::int64_t length = this->output().length;
  const std::int64_t width = this->output().width;
  for (std::int64_t w = 0; w < batch.all(); ++w) {
    const std::int64_t window = w % batch.windows;
    const auto from = as_matrix(x + window * this->input().size(), length, 3 * width);
    const auto by_y = as_matrix(dy + w * this->output().size(), length, width);
    auto by_x = as_matrix(dx + w * this->input().size(), length, 3 * width);
    const T* attention = attention_.data() + window * heads_ * length * held_length_;
    for (std::int64_t h = 0; h < heads_; ++h, attention += length * held_length_) {
      const auto queries = from.middleCols(h * head_, head_);
      const auto keys = from.middleCols(width + h * head_, head_);
      const auto values = from.middleCols(2 * width + h * head_, head_);
      const auto given = as_matrix(attention, length, held_length_).leftCols(length);
      const auto by_given = by_y.middleCols(h * head_, head_);
      by_x.middleCols(2 * width + h * head_, head_).noalias() = given.transpose() * by_given;
      // Softmax backward: each row's gradient minus its mean weighted by the softmax, times
      // softmax.
      by_attention_.noalias() = by_given * values.transpose();
      for (std::int64_t i = 0; i < length; ++i) {
        auto row = by_attention_.row(i).array();
        const T mean = (row * given.row(i).array()).sum();
        row = factor_ * given.row(i).array() * (row - mean);
      }
      by_x.middleCols(h * head_, head_).noalias() = by_attention_ * keys;
      by_x.middleCols(width + h * head_, head_).noalias() = by_attention_.transpose() * queries;
    }
  }
}

template class DotProductAttention<float>;
template class DotProductAttention<double>;

}  // namespace piae::nets
