#include "augment/starting_windows.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <numeric>

#include "augment/interpolation.hpp"
#include "base/error.hpp"

namespace piae::augment {

std::vector<std::int64_t> foreign_neighbours(const signal::WindowSet& known,
                                             const signal::WindowSet& healthy, int among) {
  std::vector<Window> windows;
  for (const signal::WindowSet* const set : {&known, &healthy}) {
    for (std::size_t i = 0; i < set->size(); ++i) windows.push_back(set->window(i));
  }
  if (static_cast<std::size_t>(among) >= windows.size()) {
    throw Error(Exit::usage, fmt::format("--foreign-among {}: there are {} real windows; give at "
                                         "most --foreign-among {}",
                                         among, windows.size(), windows.size() - 1));
  }
  std::vector<std::int64_t> foreign;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::vector<std::size_t> near = nearest_to(i, windows, static_cast<std::size_t>(among));
    foreign.push_back(std::ranges::count_if(near, [&](std::size_t j) {
      return j >= known.size() || known.labels[j] != known.labels[i];
    }));
  }
  return foreign;
}

std::vector<std::size_t> even_turns(std::span<const std::int64_t> weights, std::size_t count) {
  const std::int64_t sum = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  std::vector<std::int64_t> lags(
      weights.size());  // part of the turns so far - own turns, times sum
  std::vector<std::size_t> turns;
  for (std::size_t turn = 0; turn < count; ++turn) {
    for (std::size_t i = 0; i < lags.size(); ++i) lags[i] += weights[i];
    const auto next = std::ranges::max_element(lags);
    *next -= sum;
    turns.push_back(static_cast<std::size_t>(next - lags.begin()));
  }
  return turns;
}

}  // namespace piae::augment
