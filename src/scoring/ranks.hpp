#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace piae::scoring {

/// Returns the ranks of n values: the smallest has rank 1, the largest n, and equal values share
/// the mean of their ranks. Values that differ by less than 1e-9 of the largest magnitude count as
/// equal, because the difference is rounding.
std::vector<double> ranks(std::span<const double> values);

/// Ranks of methods, averaged over blocks such as seeds (Demsar 2006, "Statistical comparisons of
/// classifiers over multiple data sets", Section 3.2.2).
struct AverageRanks {
  std::size_t blocks = 0;
  std::vector<double> average;  ///< for each method; the best of a block has rank 1
  /// p of the hypothesis that all methods are equally good: Friedman's test with the statistic of
  /// Iman and Davenport, Demsar's F_F. It is not corrected for equal values, which make it slightly
  /// too large. Empty for fewer than two methods or blocks.
  std::optional<double> p;
  /// Two average ranks that differ by more than this differ significantly at the level 0.05, by the
  /// Nemenyi test. Empty if p is empty.
  std::optional<double> critical_difference;
};

/// Ranks the methods. `blocks` holds for each block one value for each method; larger is better.
/// Throws std::logic_error without blocks and if blocks differ in length.
AverageRanks average_ranks(const std::vector<std::vector<double>>& blocks);

/// Returns Demsar's q_alpha (his Table 5a) for a level: the quantile of the range of `methods`
/// independent normal variables, divided by sqrt(2). There must be at least two methods.
double nemenyi_quantile(std::size_t methods, double level);

}  // namespace piae::scoring
