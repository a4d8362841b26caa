#include "inspection/value_counts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "inspection/raw_flaws.hpp"
#include "spectra/floors.hpp"

namespace piae::inspection {

namespace {

constexpr std::size_t most_few_values = 16;
constexpr std::size_t samples_a_value = 10;

constexpr std::size_t values_nearby = 4;
// The sum of two log chances, one for each end, follows a gamma distribution: (1 + 10) exp(-10) is
// 5e-4, in each of the two tests.
constexpr double least_evidence = 10;

// No converter has more than 24 bits. Smaller differences come from rounding, which hides that a
// computed signal repeats itself.
const double finest = std::ldexp(1, -24);  // of the range

struct NearbyValue {
  double distance = 0;     ///< from the extreme value
  std::size_t visits = 0;  ///< samples in a row are one visit
  std::size_t samples = 0;
};

/// Returns the extreme value and the next four levels, at steps of at least `step`.
std::vector<NearbyValue> levels_from(std::span<const double> samples, double extreme, double step) {
  std::vector<NearbyValue> levels;
  double last = -1;
  for (const double x : samples) {
    const double distance = std::round(std::abs(extreme - x) / step) * step;
    const bool stays = distance == last;
    last = distance;
    if (levels.size() > values_nearby && distance > levels.back().distance) continue;
    auto at = std::ranges::lower_bound(levels, distance, {}, &NearbyValue::distance);
    if (at == levels.end() || at->distance != distance) at = levels.insert(at, {distance, 0, 0});
    at->visits += stays ? 0 : 1;
    ++at->samples;
    if (levels.size() > values_nearby + 1) levels.pop_back();
  }
  return levels;
}

/// Returns a lower bound of the negative log chance that `count` of n exceed a share (Chernoff).
double evidence_of(double count, double n, double share) {
  if (count <= share * n) return 0;
  const double found = count / n;
  const double others = found < 1 ? (1 - found) * std::log((1 - found) / (1 - share)) : 0;
  return n * (found * std::log(found / share) + others);
}

/// Results of both tests at one end of the values, as negative log chances.
struct Evidence {
  double by_levels = 0;
  double by_distance = 0;
};

Evidence evidence_at(const std::vector<NearbyValue>& levels, double quantum) {
  std::vector<double> visits;
  visits.reserve(levels.size());
  for (const NearbyValue& level : levels) visits.push_back(static_cast<double>(level.visits));
  const double all = std::accumulate(visits.begin(), visits.end(), 0.0);
  const double repeats = spectra::median({visits.begin() + 1, visits.end()});
  const double width = levels.back().distance + quantum;
  const double loosest = 1 / std::sqrt(static_cast<double>(levels.size()));
  return {evidence_of(visits.front(), all, loosest),
          evidence_of(visits.front() / repeats - 1, all / repeats - 1, std::sqrt(quantum / width))};
}

}  // namespace

std::optional<std::size_t> few_values(std::span<const double> samples) {
  std::vector<double> values;
  for (const double x : samples) {
    const auto at = std::ranges::lower_bound(values, x);
    if (at != values.end() && *at == x) continue;
    if (values.size() == most_few_values) return std::nullopt;
    values.insert(at, x);
  }
  if (samples.size() < samples_a_value * values.size()) return std::nullopt;
  return values.size();
}

CutTops cut_tops(std::span<const double> samples) {
  if (samples.empty()) return {};
  const auto [lowest, highest] = std::ranges::minmax(samples);
  if (lowest == highest) return {};
  const double step = finest * (highest - lowest);
  const double quantum = std::max(quantum_of(samples), step);
  const std::vector<NearbyValue> high = levels_from(samples, highest, step);
  const std::vector<NearbyValue> low = levels_from(samples, lowest, step);
  const Evidence above = evidence_at(high, quantum);
  const Evidence below = evidence_at(low, quantum);
  CutTops cut{0, 0, highest, lowest};
  const auto keep = [&](double evidence_above, double evidence_below) {
    if (evidence_above + evidence_below < least_evidence) return;
    if (evidence_above >= least_evidence / 2) cut.on_highest = high.front().samples;
    if (evidence_below >= least_evidence / 2) cut.on_lowest = low.front().samples;
  };
  keep(above.by_levels, below.by_levels);
  keep(above.by_distance, below.by_distance);
  return cut;
}

}  // namespace piae::inspection
