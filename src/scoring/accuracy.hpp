#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace piae::scoring {

/// How often windows of one class were taken for another: rows are the true class, columns the
/// predicted one.
struct Confusion {
  std::size_t classes = 0;           ///< C
  std::vector<std::int64_t> counts;  ///< row-major [C, C]

  [[nodiscard]] std::int64_t at(std::size_t truth, std::size_t predicted) const {
    return counts[truth * classes + predicted];
  }
  bool operator==(const Confusion&) const = default;
};

/// labels and predictions are [n], each in {0, ..., classes - 1}. Throws std::logic_error when they
/// differ in length or hold anything else.
Confusion confusion_matrix(std::span<const std::int32_t> labels,
                           std::span<const std::int32_t> predictions, std::size_t classes);

/// Share of windows that were recognised, in [0, 1] (paper, eq. 29). Throws std::logic_error when
/// there is not one window.
double accuracy(const Confusion& confusion);

}  // namespace piae::scoring
