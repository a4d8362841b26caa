#include "scoring/auroc.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace piae::scoring {

double auroc(std::span<const double> negative, std::span<const double> positive) {
  if (negative.empty() || positive.empty()) {
    throw std::logic_error("an operating characteristic needs positive and negative values");
  }
  std::vector<double> sorted(negative.begin(), negative.end());
  std::ranges::sort(sorted);
  double won = 0;
  for (const double value : positive) {
    const auto [from, to] = std::ranges::equal_range(sorted, value);
    won += static_cast<double>(from - sorted.begin()) + static_cast<double>(to - from) / 2;
  }
  return won / static_cast<double>(negative.size()) / static_cast<double>(positive.size());
}

}  // namespace piae::scoring
