#include "symptoms/running_median.hpp"

#include "scoring/statistics.hpp"

namespace piae::symptoms {

Eigen::ArrayXd running_median(const Eigen::ArrayXd& values, Eigen::Index width) {
  const Eigen::Index half = width / 2;
  Eigen::ArrayXd longer(values.size() + 2 * half);
  longer << values.head(half).reverse(), values, values.tail(half).reverse();
  Eigen::ArrayXd medians(values.size());
  for (Eigen::Index i = 0; i < medians.size(); ++i) {
    const double* const first = longer.data() + i;
    medians[i] = scoring::median({first, first + width});
  }
  return medians;
}

}  // namespace piae::symptoms
