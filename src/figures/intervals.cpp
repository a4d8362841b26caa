#include "figures/intervals.hpp"

#include "figures/numbers.hpp"

namespace piae::figures {

std::vector<std::string> shown_interval(const scoring::Summary& summary) {
  if (!summary.interval) return {"", ""};
  return {digits(summary.interval->low), digits(summary.interval->high)};
}

}  // namespace piae::figures
