#pragma once

#include <Eigen/Core>

namespace piae::symptoms {

/// Difference of a window's spectrum from those of healthy windows. Let s be the shape of its
/// spectrum (spectra/bands.hpp), m and v the mean and variance of s over the healthy windows, band
/// by band, and d the mean over the bands of the root of v. Then
///
///     distance = root of the mean over the bands of (s - m)^2 / (v + (d / 2)^2).
///
/// d limits the weight of a band in which healthy windows happen to be alike. For windows of
/// another speed, v also holds the square of the change that the speed allows (speed_change.hpp).
/// The threshold is 1.2 times the largest distance of a left-out healthy window: the windows are
/// cut into four blocks, and each is compared with the other three, so that overlapping windows do
/// not vouch for each other.
class Novelty {
 public:
  /// Takes the shapes of n healthy windows, a row for each, in order of time; n is at least 4.
  /// `speed_ratio` is the speed of the windows to be compared over that of the healthy ones.
  explicit Novelty(const Eigen::ArrayXXd& healthy, double speed_ratio = 1);

  /// Returns the distance of a shape divided by the threshold: more than 1 is new.
  [[nodiscard]] double of(const Eigen::ArrayXd& shape) const;
  /// Returns [n] the novelty of each healthy window when its block is left out: at most 1 / 1.2.
  [[nodiscard]] const Eigen::ArrayXd& of_healthy() const { return of_healthy_; }

 private:
  struct Likeness {
    Eigen::ArrayXd mean;
    Eigen::ArrayXd deviation;

    [[nodiscard]] double distance(const Eigen::ArrayXd& shape) const;
  };
  static Likeness likeness(const Eigen::ArrayXXd& shapes);

  Likeness all_;
  Eigen::ArrayXd of_healthy_;
  double threshold_ = 0;
};

}  // namespace piae::symptoms
