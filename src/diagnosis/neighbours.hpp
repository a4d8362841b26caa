#pragma once

#include <Eigen/Core>

#include "diagnosis/band_powers.hpp"

namespace piae::diagnosis {

/// Searches the nearest among known windows, by band powers.
class Neighbours {
 public:
  /// Number of windows per matrix product; their distances fit into the caches.
  static constexpr Eigen::Index at_a_time = 64;

  explicit Neighbours(BandPowers known) : known_(std::move(known)), squares_(squares_of(known_)) {}

  /// Returns [known, asked] the squared distance of each known window to each window of `asked`.
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
