#include "scoring/ranks.hpp"

#include <algorithm>
#include <boost/math/quadrature/trapezoidal.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "scoring/distributions.hpp"

namespace piae::scoring {

namespace {

constexpr double level = 0.05;

/// Returns the probability that `count` standard normal variables lie within `range` of each other.
/// It integrates over the smallest of them, z: all others then lie between z and z + range.
double range_probability(std::size_t count, double range) {
  const auto density = [&](double z) {
    const double others = normal_below(z + range) - normal_below(z);
    return normal_density(z) * std::pow(others, static_cast<double>(count - 1));
  };
  constexpr double end = 9;  // less than 1e-18 of the probability lies beyond
  return static_cast<double>(count) * boost::math::quadrature::trapezoidal(density, -end, end);
}

std::vector<double> ranks_of_the_best_first(const std::vector<double>& values) {
  std::vector<double> negated;
  std::ranges::transform(values, std::back_inserter(negated), std::negate());
  return ranks(negated);
}

/// Returns the p of Iman and Davenport's F for average ranks of k methods over n blocks.
double p_of_friedman(const std::vector<double>& average, double n) {
  const auto k = static_cast<double>(average.size());
  double squares = 0;
  for (const double rank : average) squares += rank * rank;
  const double chi_squared = 12 * n / (k * (k + 1)) * (squares - k * (k + 1) * (k + 1) / 4);
  const double rest = n * (k - 1) - chi_squared;
  // If all blocks rank all methods alike, F is infinite. Then p is the probability that all other
  // blocks have the order of the first.
  if (rest <= 1e-9 * chi_squared) return std::pow(std::tgamma(k + 1), 1 - n);
  const double f = std::max(0.0, (n - 1) * chi_squared / rest);
  return fisher_f_above(f, k - 1, (k - 1) * (n - 1));
}

}  // namespace

std::vector<double> ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] - values[order[end - 1]] <= 1e-9 * largest) {
      ++end;
    }
    // The ranks are first + 1 to end.
    for (std::size_t i = first; i < end; ++i) {
      ranks[order[i]] = static_cast<double>(first + 1 + end) / 2;
    }
    first = end;
  }
  return ranks;
}

AverageRanks average_ranks(const std::vector<std::vector<double>>& blocks) {
  if (blocks.empty() || blocks.front().empty())
    throw std::logic_error("ranks need at least one value");
  const std::size_t methods = blocks.front().size();
  const auto n = static_cast<double>(blocks.size());
  AverageRanks result;
  result.blocks = blocks.size();
  result.average.assign(methods, 0);
  for (const std::vector<double>& block : blocks) {
    if (block.size() != methods) throw std::logic_error("blocks differ in length");
    const std::vector<double> own = ranks_of_the_best_first(block);
    for (std::size_t i = 0; i < methods; ++i) result.average[i] += own[i] / n;
  }
  if (methods < 2 || blocks.size() < 2) return result;
  const auto k = static_cast<double>(methods);
  result.p = p_of_friedman(result.average, n);
  result.critical_difference = nemenyi_quantile(methods, level) * std::sqrt(k * (k + 1) / (6 * n));
  return result;
}

double nemenyi_quantile(std::size_t methods, double level) {
  double low = 0;
  double high = 20;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (range_probability(methods, middle) < 1 - level ? low : high) = middle;
  }
  return (low + high) / 2 / std::sqrt(2.0);
}

}  // namespace piae::scoring
