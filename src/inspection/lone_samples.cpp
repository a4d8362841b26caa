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
constexpr double times_farther_in_pair = 100;
constexpr std::size_t most_numbers_above = 10;  // a header's
constexpr double times_farther_above = 3;

/// Range of the neighbours on either side of one sample, or of two.
struct Range {
  double middle = 0;
  double half = 0;
};

/// Returns the range of the neighbours of the samples from `first` to `last`.
Range range_around(std::span<const double> samples, std::size_t first, std::size_t last) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto add = [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      low = std::min(low, samples[k]);
      high = std::max(high, samples[k]);
    }
  };
  add(first - std::min(first, neighbours), first);
  add(last + 1, std::min(samples.size(), last + 1 + neighbours));
  return {.middle = (low + high) / 2, .half = (high - low) / 2};
}

bool is_alone(std::span<const double> samples, std::size_t i) {
  const Range range = range_around(samples, i, i);
  return std::abs(samples[i] - range.middle) > times_farther * range.half;
}

/// True if two adjacent samples are a spike.
bool are_a_pair(std::span<const double> samples, std::size_t first) {
  if (first + 1 >= samples.size()) return false;
  const Range range = range_around(samples, first, first + 1);
  const double one = std::abs(samples[first] - range.middle);
  const double other = std::abs(samples[first + 1] - range.middle);
  return std::min(one, other) > times_farther * range.half &&
         std::max(one, other) > times_farther_in_pair * range.half;
}

/// Returns how many first samples are three times as far from the mean as all others, ten at most:
/// numbers of a header, such as the rate and the count of samples.
std::size_t count_numbers_above(std::span<const double> samples, double mean) {
  const auto distance = [&](std::size_t i) { return std::abs(samples[i] - mean); };
  double farthest_below = 0;
  for (std::size_t i = most_numbers_above; i < samples.size(); ++i) {
    farthest_below = std::max(farthest_below, distance(i));
  }
  for (std::size_t count = most_numbers_above; count > 0; --count) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) nearest = std::min(nearest, distance(i));
    if (nearest > times_farther_above * farthest_below) return count;
    farthest_below = std::max(farthest_below, distance(count - 1));
  }
  return 0;
}

}  // namespace

LoneSamples lone_samples(std::span<const double> samples) {
  if (samples.size() <= 2 * neighbours) return {};
  const double mean =
      std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
  const std::size_t above = count_numbers_above(samples, mean);
  std::vector<std::size_t> candidates;
  LoneSamples lone;
  bool ends_pair = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool begins_pair = are_a_pair(samples, i);
    if (i < above || begins_pair || ends_pair || is_alone(samples, i)) {
      candidates.push_back(i);
    } else {
      lone.others = std::max(lone.others, std::abs(samples[i] - mean));
    }
    ends_pair = begins_pair;
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
