#include "figures/thinning.hpp"

#include <algorithm>

namespace piae::figures {

using Eigen::Index;

Thinning::Thinning(Index numbers, Index most)
    : numbers_(numbers), of_each_((numbers + most - 1) / most) {}

Index Thinning::size(Index group) const { return std::min(of_each_, numbers_ - group * of_each_); }

double Thinning::middle(Index group) const {
  return static_cast<double>(group * of_each_) + static_cast<double>(size(group) - 1) / 2;
}

Eigen::ArrayXd Thinning::highest(const Eigen::Ref<const Eigen::ArrayXd>& values) const {
  Eigen::ArrayXd result(groups());
  for (Index i = 0; i < groups(); ++i) {
    result[i] = values.segment(i * of_each_, size(i)).maxCoeff();
  }
  return result;
}

Eigen::ArrayXd Thinning::lowest(const Eigen::Ref<const Eigen::ArrayXd>& values) const {
  return -highest(-values);
}

}  // namespace piae::figures
