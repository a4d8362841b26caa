#include "inspection/raw_flaws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace piae::inspection {

namespace {

constexpr std::size_t fewest_steps = 20;
constexpr std::size_t steps_to_one_back = 1000;
constexpr std::size_t fewest_clipped = 3;
constexpr double shortest_held = 10;          // samples
constexpr double chance_of_a_stretch = 1e-3;  // in a record

/// Two or more consecutive samples of one value.
struct Run {
  std::size_t first;
  std::size_t length;
};

std::vector<Run> runs_of(std::span<const double> samples) {
  std::vector<Run> runs;
  for (std::size_t first = 0; first < samples.size();) {
    std::size_t end = first + 1;
    while (end < samples.size() && samples[end] == samples[first]) ++end;
    if (end - first > 1) runs.push_back({first, end - first});
    first = end;
  }
  return runs;
}

/// Returns how often each sample is written: the length of the shortest run if all samples are in
/// runs, apart from cut ones at the ends; otherwise 1.
std::size_t times_written(std::span<const double> samples, const std::vector<Run>& runs) {
  std::size_t in_runs = 0;
  std::size_t shortest = samples.size();
  for (const Run& run : runs) {
    in_runs += run.length;
    if (run.first == 0 || run.first + run.length == samples.size()) continue;
    shortest = std::min(shortest, run.length);
  }
  constexpr std::size_t ends = 2;
  return in_runs + ends >= samples.size() ? shortest : 1;
}

/// True if a step into or out of the run exceeds that at the top of any smooth signal.
bool is_abrupt(std::span<const double> samples, const Run& run, double quantum) {
  const auto m = static_cast<double>(run.length);
  const double most = (std::pow((m + 1) / (m - 1), 2) + 1) * quantum;
  const double value = samples[run.first];
  const std::size_t end = run.first + run.length;
  return (run.first > 0 && std::abs(samples[run.first - 1] - value) > most) ||
         (end < samples.size() && std::abs(samples[end] - value) > most);
}

void add_run(Stretches& stretches, std::span<const double> samples, const Run& run) {
  ++stretches.count;
  stretches.samples += run.length;
  if (run.length <= stretches.longest) return;
  stretches.longest = run.length;
  stretches.longest_first = run.first;
  stretches.value = samples[run.first];
}

/// Returns the run length that occurs by chance in one of a thousand records of n samples, if each
/// sample repeats its predecessor with probability p: n (1 - p) runs start, and each reaches the
/// length m with probability p^(m - 1).
double length_by_chance(double n, double repeats) {
  const double runs = n * (1 - repeats);
  return 1 + std::log(chance_of_a_stretch / runs) / std::log(repeats);
}

}  // namespace

bool goes_one_way(std::span<const double> samples) {
  std::size_t up = 0;
  std::size_t down = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i] > samples[i - 1]) ++up;
    if (samples[i] < samples[i - 1]) ++down;
  }
  return up + down >= fewest_steps && std::min(up, down) * steps_to_one_back <= up + down;
}

double quantum_of(std::span<const double> samples) {
  std::vector<double> values(samples.begin(), samples.end());
  std::ranges::sort(values);
  double quantum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step > 0) quantum = std::min(quantum, step);
  }
  return quantum;
}

Stretches clipped_peaks(std::span<const double> samples) {
  const auto [low, high] = std::ranges::minmax(samples);
  const double quantum = quantum_of(samples);
  const std::vector<Run> runs = runs_of(samples);
  const std::size_t written = times_written(samples, runs);
  Stretches clipped;
  for (const Run& run : runs) {
    const double value = samples[run.first];
    if (run.length <= written && written > 1) continue;  // one sample
    if ((value == low || value == high) && is_abrupt(samples, run, quantum)) {
      add_run(clipped, samples, run);
    }
  }
  return clipped.samples < fewest_clipped ? Stretches{} : clipped;
}

Stretches held_values(std::span<const double> samples) {
  const auto [low, high] = std::ranges::minmax(samples);
  const double quantum = quantum_of(samples);
  const std::vector<Run> runs = runs_of(samples);
  double repeats = 0;
  for (const Run& run : runs) repeats += static_cast<double>(run.length - 1);
  const auto n = static_cast<double>(samples.size());
  Stretches held;
  if (repeats == 0) return held;
  const double least = std::max(shortest_held, length_by_chance(n, repeats / n));
  for (const Run& run : runs) {
    const double value = samples[run.first];
    const bool at_an_end = value == low || value == high;
    if (at_an_end || static_cast<double>(run.length) < least) continue;
    if (is_abrupt(samples, run, quantum)) add_run(held, samples, run);
  }
  return held;
}

}  // namespace piae::inspection
