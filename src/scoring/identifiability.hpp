#pragma once

#include <span>
#include <vector>

namespace piae::scoring {

/// How well inferred values of a parameter agree with the true ones.
struct Agreement {
  double r2 = 0;  ///< 1 - sum (inferred - true)^2 / sum (true - mean)^2: 1 is perfect, 0 no better
                  ///< than always naming the true mean, below 0 worse than that
  double bias = 0;          ///< mean of inferred - true, in parts of the true mean
  double correlation2 = 0;  ///< square of Pearson's correlation: what R^2 could reach by a linear
                            ///< calibration, for which one must know the truth
};

/// Both of the same length. Throws std::logic_error where the truth does not vary. Inferred values
/// that do not vary have the correlation 0.
Agreement agreement(std::span<const double> truth, std::span<const double> inferred);

/// A scatter plot in numbers: what was inferred where the truth lies in one part of its range.
struct ScatterRow {
  double truth_low = 0;
  double truth_high = 0;
  std::size_t count = 0;
  double inferred_p10 = 0;  ///< quantiles, linear between order statistics
  double inferred_p50 = 0;
  double inferred_p90 = 0;
};

/// In `groups` groups of equal count by the truth, ascending; fewer where there are fewer values.
std::vector<ScatterRow> scatter(std::span<const double> truth, std::span<const double> inferred,
                                std::size_t groups);

}  // namespace piae::scoring
