#include "symptoms/running_median.hpp"

#include <algorithm>
#include <vector>

namespace piae::symptoms {

namespace {

/// Puts a number in the place of another one, and moves those between so that all stay in order.
void replace(std::vector<double>& sorted, double old, double with) {
  const auto from = std::ranges::lower_bound(sorted, old);
  const auto to = std::ranges::lower_bound(sorted, with);
  if (from < to) {
    *std::move(from + 1, to, from) = with;
  } else {
    std::move_backward(to, from, from + 1);
    *to = with;
  }
}

}  // namespace

Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width) {
  const Eigen::Index half = width / 2;
  Eigen::ArrayXd longer(values.size() + 2 * half);
  longer << values.head(half).reverse(), values, values.tail(half).reverse();
  Eigen::ArrayXd medians(values.size());
  std::vector<double> sorted(longer.begin(), longer.begin() + width);
  std::ranges::sort(sorted);
  for (Eigen::Index i = 0; i < medians.size(); ++i) {
    medians[i] = sorted[static_cast<std::size_t>(half)];
    if (i + 1 < medians.size()) replace(sorted, longer[i], longer[i + width]);
  }
  return medians;
}

}  // namespace piae::symptoms
