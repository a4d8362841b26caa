#pragma once

#include <Eigen/Core>

namespace piae::symptoms {

/// How much the spectrum of a window differs from those of healthy windows. With s the shape of its
/// spectrum (spectra/bands.hpp), m and v mean and variance of that over the healthy windows, band
/// by band, and d the mean over the bands of the root of v,
///
///     distance = root of the mean over the bands of (s - m)^2 / (v + (d / 2)^2).
///
/// d keeps a band in which healthy windows happen to be much alike from counting for much. The
/// threshold is 1.2 times the largest distance of a healthy window, when it is left out: the
/// windows are cut into four blocks, and each is compared with the other three, so that windows
/// that overlap do not vouch for each other.
class Novelty {
 public:
  /// The shapes of n healthy windows, a row for each, in the order of time; n is at least 4.
  explicit Novelty(const Eigen::ArrayXXd& healthy);

  /// The distance of a shape by the threshold: more than 1 is new.
  [[nodiscard]] double of(const Eigen::ArrayXd& shape) const;
  /// [n] the same of each healthy window when its block is left out: at most 1 / 1.2.
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
