#include "inspection/lone_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace piae::inspection {

namespace {

constexpr std::size_t neighbours = 8;  // on either side
constexpr double times_farther = 10;

bool is_lone(std::span<const double> samples, std::size_t i) {
  const std::size_t first = i - std::min(i, neighbours);
  const std::size_t end = std::min(samples.size(), i + neighbours + 1);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t k = first; k < end; ++k) {
    if (k == i) continue;
    low = std::min(low, samples[k]);
    high = std::max(high, samples[k]);
  }
  return std::abs(samples[i] - (low + high) / 2) > times_farther * (high - low) / 2;
}

}  // namespace

LoneSamples lone_samples(std::span<const double> samples) {
  if (samples.size() <= 2 * neighbours) return {};
  const double mean =
      std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
  std::vector<std::size_t> candidates;
  LoneSamples lone;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_lone(samples, i)) {
      candidates.push_back(i);
    } else {
      lone.others = std::max(lone.others, std::abs(samples[i] - mean));
    }
  }
  double farthest = lone.others;
  for (const std::size_t i : candidates) {
    const double distance = std::abs(samples[i] - mean);
    if (distance <= lone.others) continue;
    ++lone.count;
    if (distance <= farthest) continue;
    farthest = distance;
    lone.farthest = i;
    lone.value = samples[i];
  }
  return lone;
}

}  // namespace piae::inspection
