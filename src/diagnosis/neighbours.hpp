#pragma once

#include <Eigen/Core>

#include "diagnosis/band_powers.hpp"

namespace piae::diagnosis {

/// Windows among which the nearest is looked for, by their band powers.
class Neighbours {
 public:
  /// As many windows are asked about together as their distances fit into the caches.
  static constexpr Eigen::Index at_a_time = 64;

  explicit Neighbours(BandPowers known) : known_(std::move(known)), squares_(squares_of(known_)) {}

  /// [known, asked] the squared distance of each of the known windows to each of those asked about.
  [[nodiscard]] Eigen::MatrixXd squared_distances(const BandPowers& asked) const;

  [[nodiscard]] const BandPowers& known() const { return known_; }

 private:
  static Eigen::VectorXd squares_of(const BandPowers& windows) {
    return windows.rowwise().squaredNorm();
  }

  BandPowers known_;
  Eigen::VectorXd squares_;
};

}  // namespace piae::diagnosis
