#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/label.hpp"

namespace piae::scoring {

/// Statistics of independent repeats of a measurement.
struct Summary {
  struct Interval {
    double low;
    double high;
  };

  std::size_t count = 0;
  double mean = 0;
  /// Sample standard deviation (divided by n - 1). Empty for a single repeat.
  std::optional<double> deviation;
  /// 95 % confidence interval of the mean, by Student's t with n - 1 degrees of freedom. Empty for
  /// a single repeat.
  std::optional<Interval> interval;
};

/// Throws std::logic_error without values.
Summary summarise(std::span<const double> values);

/// Returns the part of the variance that lies between the classes of the values (eta squared): 0 if
/// all classes have the same mean, 1 if the values do not vary within classes. n values that do not
/// depend on their g classes have (g - 1) / (n - 1) on average.
double share_between_classes(std::span<const double> values, std::span<const Label> labels);

}  // namespace piae::scoring
