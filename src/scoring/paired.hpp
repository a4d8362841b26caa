#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::scoring {

/// Wilcoxon's signed-rank test (Wilcoxon 1945). Differences of zero are left out, as he did, and
/// equal ones share the mean of their ranks.
struct SignedRanks {
  double positive = 0;  ///< sum of the ranks of the positive differences
  double negative = 0;
  /// Two-sided, of positive and negative being equally likely for each difference. Exact for any
  /// number of them, with equal ones too: from all 2^n choices of signs, none of which is drawn. 1
  /// where all differences are zero.
  double p = 1;

  /// The matched-pairs rank-biserial correlation (Kerby 2014, "The simple difference formula"): the
  /// share of the ranks that is positive, minus the negative. From -1 to 1; 0 without differences.
  [[nodiscard]] double rank_biserial() const;
};

SignedRanks signed_ranks(std::span<const double> differences);

/// What pairs say about a being larger than b.
struct PairedComparison {
  Summary difference;  ///< a - b, with its interval
  double rank_biserial = 0;
  std::optional<double> p;  ///< of Wilcoxon's test. One pair has none
};

/// Throws std::logic_error when there is no pair, or one without a partner.
PairedComparison compare_pairs(std::span<const double> a, std::span<const double> b);

/// The smallest p that this number of pairs can give: 2 / 2^n.
double smallest_p(std::size_t pairs);

/// Holm's correction (Holm 1979): p values, in the order given, of a family of tests, such that the
/// chance of any false one below a level is that level at most.
std::vector<double> holm(std::span<const double> p);

}  // namespace piae::scoring
