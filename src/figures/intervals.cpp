#include "figures/intervals.hpp"

#include "figures/numbers.hpp"

namespace piae::figures {

namespace {

constexpr std::size_t fewest_seeds_of_an_interval = 3;

}  // namespace

std::vector<std::string> shown_interval(const scoring::Summary& summary) {
  if (summary.count < fewest_seeds_of_an_interval) return {"", ""};
  return {digits(summary.interval->low), digits(summary.interval->high)};
}

}  // namespace piae::figures
