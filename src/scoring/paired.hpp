#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::scoring {

/// Result of Wilcoxon's signed-rank test (Wilcoxon 1945). Differences of zero are left out, as in
/// his paper, and equal differences share the mean of their ranks.
struct SignedRanks {
  double positive = 0;  ///< sum of the ranks of the positive differences
  double negative = 0;  ///< sum of the ranks of the negative differences
  /// Two-sided p of the hypothesis that each difference is as likely positive as negative. It is
  /// exact for any number of differences, even with equal ones: all 2^n choices of signs are
  /// counted, without sampling. It is 1 if all differences are zero.
  double p = 1;

  /// Returns the matched-pairs rank-biserial correlation (Kerby 2014, "The simple difference
  /// formula"): the share of the ranks of positive differences, minus that of negative ones. From
  /// -1 to 1; 0 if all differences are zero.
  [[nodiscard]] double rank_biserial() const;
};

SignedRanks signed_ranks(std::span<const double> differences);

/// Paired difference of a and b.
struct PairedDifference {
  Summary difference;        ///< a - b, with its interval
  double rank_biserial = 0;  ///< see SignedRanks
  std::optional<double> p;   ///< from Wilcoxon's test; empty for a single pair
};

/// Compares a and b, [n]; value i of both makes a pair. Throws std::logic_error without pairs and
/// if the lengths differ.
PairedDifference paired_difference(std::span<const double> a, std::span<const double> b);

/// Returns the smallest p that Wilcoxon's test can give for this number of pairs: 2 / 2^n.
double smallest_p(std::size_t pairs);

/// Returns Holm's correction (Holm 1979) of the p values of a family of tests, in the given order.
/// If none of the tested differences exists, the probability that any corrected value is below a
/// level is at most that level.
std::vector<double> holm(std::span<const double> p);

}  // namespace piae::scoring
