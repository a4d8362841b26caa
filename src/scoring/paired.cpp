#include "scoring/paired.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "scoring/ranks.hpp"

namespace piae::scoring {

namespace {

/// Returns twice a rank, a whole number even if several values share a rank that ends in .5.
std::size_t doubled(double rank) { return static_cast<std::size_t>(std::lround(2 * rank)); }

/// Returns the probability of each possible sum of the doubled ranks of the positive differences,
/// if each difference is positive or negative with equal probability.
std::vector<double> distribution_of_sum(const std::vector<double>& ranks) {
  std::vector<double> probability{1};
  for (const double rank : ranks) {
    const std::size_t step = doubled(rank);
    std::vector<double> next(probability.size() + step, 0);
    for (std::size_t sum = 0; sum < probability.size(); ++sum) {
      next[sum] += probability[sum] / 2;
      next[sum + step] += probability[sum] / 2;
    }
    probability = std::move(next);
  }
  return probability;
}

}  // namespace

double SignedRanks::rank_biserial() const {
  const double all = positive + negative;
  return all > 0 ? (positive - negative) / all : 0;
}

SignedRanks signed_ranks(std::span<const double> differences) {
  std::vector<double> magnitudes;
  std::vector<bool> is_positive;
  for (const double difference : differences) {
    if (difference == 0) continue;
    magnitudes.push_back(std::abs(difference));
    is_positive.push_back(difference > 0);
  }
  const std::vector<double> all = ranks(magnitudes);
  SignedRanks result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    (is_positive[i] ? result.positive : result.negative) += all[i];
  }
  const std::vector<double> probability = distribution_of_sum(all);
  const std::size_t smaller = doubled(std::min(result.positive, result.negative));
  const auto end = probability.begin() + static_cast<std::ptrdiff_t>(smaller) + 1;
  result.p = std::min(1.0, 2 * std::accumulate(probability.begin(), end, 0.0));
  return result;
}

PairedDifference paired_difference(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) throw std::logic_error("paired values differ in number");
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = std::max(std::abs(a[i]), std::abs(b[i]));
    const double difference = a[i] - b[i];
    // A difference within rounding counts as zero.
    differences.push_back(std::abs(difference) > 1e-9 * size ? difference : 0);
  }
  PairedDifference result;
  result.difference = summarise(differences);
  const SignedRanks test = signed_ranks(differences);
  result.rank_biserial = test.rank_biserial();
  if (differences.size() > 1) result.p = test.p;
  return result;
}

double smallest_p(std::size_t pairs) { return 2 * std::pow(0.5, static_cast<double>(pairs)); }

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> corrected(p.size());
  double before = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double own = static_cast<double>(p.size() - i) * p[order[i]];
    before = std::max(before, std::min(1.0, own));
    corrected[order[i]] = before;
  }
  return corrected;
}

}  // namespace piae::scoring
