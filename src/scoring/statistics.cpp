#include "scoring/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "scoring/distributions.hpp"

namespace piae::scoring {

namespace {

constexpr double tail = 0.025;  // the probability on either side of a 95 % interval

double sample_deviation(std::span<const double> values, double mean) {
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace

Summary summarise(std::span<const double> values) {
  if (values.empty()) throw std::logic_error("no value to summarise");
  const auto n = static_cast<double>(values.size());
  Summary summary;
  summary.count = values.size();
  summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() == 1) return summary;
  summary.deviation = sample_deviation(values, summary.mean);
  const double half = student_t_exceeded_with(tail, n - 1) * *summary.deviation / std::sqrt(n);
  summary.interval = {summary.mean - half, summary.mean + half};
  return summary;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace piae::scoring
