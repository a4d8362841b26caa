#include "diagnosis/neighbours.hpp"

namespace piae::diagnosis {

Eigen::MatrixXd Neighbours::squared_distances(const BandPowers& asked) const {
  Eigen::MatrixXd squares = known_ * (-2 * asked.transpose());
  squares.colwise() += squares_;
  squares.rowwise() += squares_of(asked).transpose();
  return squares.cwiseMax(0);  // rounding may make them negative
}

}  // namespace piae::diagnosis
