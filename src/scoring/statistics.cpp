#include "scoring/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "scoring/distributions.hpp"

namespace piae::scoring {

namespace {

constexpr double tail = 0.025;  // probability on each side of a 95 % interval

double sample_deviation(std::span<const double> values, double mean) {
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace

Summary summarise(std::span<const double> values) {
  if (values.empty()) throw std::logic_error("a summary needs at least one value");
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

double share_between_classes(std::span<const double> values, std::span<const Label> labels) {
  struct Sum {
    double sum = 0;
    double count = 0;
  };
  std::map<Label, Sum> classes;
  Sum all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (Sum* const each : {&classes[labels[i]], &all}) {
      each->sum += values[i];
      each->count += 1;
    }
  }
  const double mean = all.sum / all.count;
  double total = 0;
  for (const double value : values) total += (value - mean) * (value - mean);
  double between = 0;
  for (const auto& [label, own] : classes) {
    const double away = own.sum / own.count - mean;
    between += own.count * away * away;
  }
  return total > 0 ? between / total : 0;
}

}  // namespace piae::scoring
