#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// What independent repeats of a measurement say about its value.
struct Summary {
  struct Interval {
    double low;
    double high;
  };

  std::size_t count = 0;
  double mean = 0;
  /// Sample standard deviation (divided by n - 1). A single repeat has none.
  std::optional<double> deviation;
  /// 95 % confidence interval of the mean, by Student's t with n - 1 degrees of freedom. A single
  /// repeat has none.
  std::optional<Interval> interval;
};

/// Throws std::logic_error when there is no value.
Summary summarise(std::span<const double> values);

/// The part of the variance of values that lies between the classes they are of (eta squared): 0
/// where all classes have the same mean, 1 where no class has a spread of its own. n values that do
/// not depend on their g classes have (g - 1) / (n - 1) of it on average.
double share_between_classes(std::span<const double> values, std::span<const Label> labels);

}  // namespace piae::scoring
