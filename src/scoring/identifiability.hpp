#pragma once

#include <span>
#include <vector>

namespace piae::scoring {

/// Agreement of inferred values of a parameter with the true ones.
struct Agreement {
  double r2 = 0;  ///< 1 - sum (inferred - true)^2 / sum (true - mean)^2: 1 is perfect, 0 no better
                  ///< than predicting the true mean, below 0 worse than that
  double bias = 0;          ///< mean of inferred - true, divided by the mean of the true values
  double correlation2 = 0;  ///< square of Pearson's correlation: the R^2 after the best linear
                            ///< calibration, for which one must know the truth
};

/// Returns R², relative bias and squared correlation of the inferred against the true values, both
/// [n]; value i of both belongs to the same window. Throws
/// std::logic_error if the truth does not vary. Constant inferred values have the correlation 0.
Agreement agreement(std::span<const double> truth, std::span<const double> inferred);

/// A group of points of a scatter plot: values with almost the same truth.
struct ScatterRow {
  double truth_low = 0;  ///< the smallest true value of the group
  double truth_high = 0;
  std::size_t count = 0;
  double inferred_p10 = 0;  ///< quantiles of the inferred values, linear between order statistics
  double inferred_p50 = 0;
  double inferred_p90 = 0;
};

/// Sorts the values by the truth and cuts them into `groups` groups of equal count, or into fewer
/// if there are fewer values.
std::vector<ScatterRow> scatter(std::span<const double> truth, std::span<const double> inferred,
                                std::size_t groups);

}  // namespace piae::scoring
