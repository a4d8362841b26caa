#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace piae::scoring {

/// Ranks from 1, of the smallest value, to n; equal values share the mean of theirs. Values that
/// differ by less than 1e-9 of the largest magnitude are equal: they differ by rounding alone.
std::vector<double> ranks(std::span<const double> values);

/// How methods stand to each other, over blocks such as seeds (Demsar 2006, "Statistical
/// comparisons of classifiers over multiple data sets", Section 3.2.2).
struct RankComparison {
  std::size_t blocks = 0;
  std::vector<double> average;  ///< rank of each method over the blocks; the best has rank 1
  /// Of all methods being alike: Friedman's test with the statistic of Iman and Davenport,
  /// Demsar's F_F. Not corrected for equal values, which make it somewhat too large. Empty for less
  /// than two methods or blocks.
  std::optional<double> p;
  /// Average ranks that differ by more differ significantly at the level 0.05, by the test of
  /// Nemenyi. Empty as p.
  std::optional<double> critical_difference;
};

/// `blocks`: of each block a value for each method; the larger the better. Throws std::logic_error
/// when there is none, or when they differ in length.
RankComparison compare_ranks(const std::vector<std::vector<double>>& blocks);

/// Demsar's q_alpha (his Table 5a) for a level: the quantile of the range of `methods` independent
/// normal variables, divided by sqrt(2). At least two methods.
double nemenyi_quantile(std::size_t methods, double level);

}  // namespace piae::scoring
