#include "scoring/identifiability.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace piae::scoring {

namespace {

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns the sum over i of (a[i] - mean of a) (b[i] - mean of b).
double co_deviation(std::span<const double> a, std::span<const double> b) {
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
  return sum;
}

/// Returns a quantile of values in ascending order, linear between neighbours.
double quantile(const std::vector<double>& values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

}  // namespace

Agreement agreement(std::span<const double> truth, std::span<const double> inferred) {
  const double of_truth = co_deviation(truth, truth);
  if (!(of_truth > 0)) throw std::logic_error("agreement needs true values that vary");
  double squares = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) squares += std::pow(inferred[i] - truth[i], 2);
  const double of_inferred = co_deviation(inferred, inferred);
  const double of_both = co_deviation(truth, inferred);
  return {1 - squares / of_truth, mean_of(inferred) / mean_of(truth) - 1,
          of_inferred > 0 ? of_both * of_both / (of_truth * of_inferred) : 0};
}

std::vector<ScatterRow> scatter(std::span<const double> truth, std::span<const double> inferred,
                                std::size_t groups) {
  std::vector<std::size_t> order(truth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return truth[i]; });
  groups = std::min(groups, truth.size());
  std::vector<ScatterRow> rows;
  for (std::size_t g = 0; g < groups; ++g) {
    const std::size_t first = g * order.size() / groups;
    const std::size_t end = (g + 1) * order.size() / groups;
    std::vector<double> own;
    for (std::size_t i = first; i < end; ++i) own.push_back(inferred[order[i]]);
    std::ranges::sort(own);
    rows.push_back({truth[order[first]], truth[order[end - 1]], own.size(), quantile(own, 0.1),
                    quantile(own, 0.5), quantile(own, 0.9)});
  }
  return rows;
}

}  // namespace piae::scoring
