#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "base/vector.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// A batch of signals [time, channel], one a row, with times of zeros before and after each of
/// them.
template <class T>
class PaddedBatch {
 public:
  PaddedBatch(std::int64_t rows, std::int64_t length, std::int64_t channels, std::int64_t padding)
      : before_(padding * channels),
        stride_(whole_rows((length + 2 * padding) * channels)),
        numbers_(Eigen::ArrayX<T>::Zero(rows * stride_)) {}

  /// The signals, without what is before them.
  Rows<T> rows() { return {numbers_.data() + before_, stride_}; }

  /// All numbers of some rows, with the zeros.
  auto all(std::int64_t first, std::int64_t count) {
    return numbers_.segment(first * stride_, count * stride_);
  }

 private:
  std::int64_t before_;
  std::int64_t stride_;
  Eigen::ArrayX<T> numbers_;
};

}  // namespace piae::nets
