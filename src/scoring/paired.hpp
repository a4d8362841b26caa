#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::scoring {

/// The result of Wilcoxon's signed-rank test (Wilcoxon 1945). Differences of zero are left out, as
/// in his paper, and equal differences share the mean of their ranks.
struct SignedRanks {
  double positive = 0;  ///< sum of the ranks of the positive differences
  double negative = 0;  ///< sum of the ranks of the negative differences
  /// Two-sided p of the hypothesis that each difference is as likely positive as negative. It is
  /// exact for any number of differences, also where some are equal: all 2^n choices of signs are
  /// counted, none is sampled. 1 where all differences are zero.
  double p = 1;

  /// The matched-pairs rank-biserial correlation (Kerby 2014, "The simple difference formula"): the
  /// share of the ranks that belongs to positive differences, minus that of negative ones. From -1
  /// to 1; 0 where all differences are zero.
  [[nodiscard]] double rank_biserial() const;
};

SignedRanks signed_ranks(std::span<const double> differences);

/// By how much a is larger than b, measured in pairs.
struct PairedDifference {
  Summary difference;        ///< a - b, with its interval
  double rank_biserial = 0;  ///< see SignedRanks
  std::optional<double> p;   ///< of Wilcoxon's test; a single pair has none
};

/// a and b are [n], value i of both making a pair. Throws std::logic_error when there is no pair,
/// and when the lengths differ.
PairedDifference paired_difference(std::span<const double> a, std::span<const double> b);

/// The smallest p that Wilcoxon's test can give for this number of pairs: 2 / 2^n.
double smallest_p(std::size_t pairs);

/// Holm's correction (Holm 1979) of the p values of a family of tests, in the order given. Where
/// none of the tested differences exists, the chance that any corrected value is below a level is
/// at most that level.
std::vector<double> holm(std::span<const double> p);

}  // namespace piae::scoring
