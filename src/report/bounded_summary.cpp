#include "report/bounded_summary.hpp"

#include <algorithm>

namespace piae::report {

void bound(scoring::Summary& summary, const Bounds& bounds) {
  constexpr std::size_t fewest_for_an_interval = 3;
  if (summary.count < fewest_for_an_interval) {
    summary.interval.reset();
  } else {
    summary.interval->low = std::max(summary.interval->low, bounds.low);
    summary.interval->high = std::min(summary.interval->high, bounds.high);
  }
}

scoring::Summary summarise_within(const Bounds& bounds, std::span<const double> values) {
  scoring::Summary summary = scoring::summarise(values);
  bound(summary, bounds);
  return summary;
}

}  // namespace piae::report
