#pragma once

#include <Eigen/Core>
#include <vector>

#include "transfer/excitation.hpp"
#include "zero/made.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// Makes fault windows of which none is known, from a prior of faults and healthy windows alone
/// (docs/piae-dt-zero.md). Drawn for each window, independent of each other:
///   - a structure that answers a blow (structure.hpp);
///   - when the defect is struck (rhythm.hpp), how strongly (load.hpp), and what a ball does beside
///     that (ball.hpp);
///   - both edges and floor of the defect (impacts.hpp);
///   - a healthy window as the background (background.hpp), knocks that have no rhythm, and rates
///     that modulate everything whatever is damaged (nuisances.hpp);
///   - how loud what is struck is over the background.
/// A window is the second half of a frame of two, so that what was struck before still rings in it.
/// Each part draws from a stream of its own: without one of them, the others stay as they are.
class Twin {
 public:
  /// The machine must outlive this. Throws Error(bad_input) where a defect of the prior's largest
  /// size cannot be in its bearing.
  Twin(const Machine& machine, const Prior& prior);

  [[nodiscard]] Made make(const Scene& scene, const Stream& random) const;

 private:
  /// What is struck, with the mean square 1.
  struct Struck {
    Eigen::ArrayXd window;
    std::vector<double> strikes_s;
  };

  [[nodiscard]] std::vector<transfer::Strike> draw_strikes(const Scene& scene,
                                                           const Stream& random) const;

  [[nodiscard]] Struck strike(const Scene& scene, const Eigen::ArrayXcd& response,
                              const Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd background(const Scene& scene, const Eigen::ArrayXcd& response,
                                          const Stream& random) const;

  const Machine& machine_;
  Prior prior_;
  double frame_s_;
};

}  // namespace piae::zero
