#include "scoring/temperature.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <stdexcept>

namespace piae::scoring {

namespace {

constexpr double farthest_temperature = 50;
constexpr int precision_bits = 20;

/// Returns the mean of -ln of the softmax probability of each class at that temperature, weighted
/// by the target probability: 1 - `rest` for the true class, the others share `rest`.
double surprise(std::span<const float> logits, Label label, double rest, double temperature) {
  const double greatest = std::ranges::max(logits);
  double sum = 0;
  double all = 0;
  for (const float logit : logits) {
    sum += std::exp((logit - greatest) / temperature);
    all += (logit - greatest) / temperature;
  }
  const double own = (logits[index_of(label)] - greatest) / temperature;
  const double other = (all - own) / static_cast<double>(logits.size() - 1);
  return std::log(sum) - (1 - rest) * own - rest * other;
}

}  // namespace

std::vector<float> tempered(std::span<const float> logits, std::size_t classes,
                            double temperature) {
  std::vector<float> all(logits.size());
  for (std::size_t begin = 0; begin < logits.size(); begin += classes) {
    const std::span<const float> row = logits.subspan(begin, classes);
    const float greatest = std::ranges::max(row);
    double sum = 0;
    for (const float logit : row) sum += std::exp((logit - greatest) / temperature);
    for (std::size_t i = 0; i < classes; ++i) {
      all[begin + i] = static_cast<float>(std::exp((row[i] - greatest) / temperature) / sum);
    }
  }
  return all;
}

double best_temperature(std::span<const float> logits, std::span<const Label> labels,
                        std::size_t classes) {
  if (labels.empty()) throw std::logic_error("fitting a temperature needs labels");
  std::vector<double> counts(classes);
  for (const Label label : labels) ++counts[index_of(label)];
  const double rest = 1 / (static_cast<double>(labels.size()) + 2);
  const auto mean_surprise = [&](double log_temperature) {
    double sum = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      sum += surprise(logits.subspan(i * classes, classes), labels[i], rest,
                      std::exp(log_temperature)) /
             counts[index_of(labels[i])];
    }
    return sum;
  };
  const double limit = std::log(farthest_temperature);
  const double found =
      boost::math::tools::brent_find_minima(mean_surprise, -limit, limit, precision_bits).first;
  return std::exp(found);
}

}  // namespace piae::scoring
