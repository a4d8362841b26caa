#pragma once

#include <Eigen/Core>
#include <vector>

#include "impacts/times.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// Makes fault windows without any fault recording, from a prior of faults and from healthy windows
/// (docs/piae-dt-zero.md). Draws for each window, independently:
///  - the response of a structure to an impact (structure.hpp);
///  - times and strengths of impacts, and both edges and floor of the defect (impacts.hpp), with
/// the disorder of a ball (ball.hpp);
///  - a healthy window as the background, stray impacts, and a modulation that does not depend on
/// the fault (background.hpp);
///  - the level of the impacts over the background.
/// A window is the second half of a frame of two windows, so that earlier impacts still ring in it.
/// Each part has its own stream: switching one part off does not change the others.
class Twin {
 public:
  /// The machine must outlive this. Throws Error(bad_input) if a defect of the prior's largest size
  /// does not fit into its bearing.
  Twin(const Machine& machine, const Prior& prior);

  [[nodiscard]] signal::MadeWindow make(const Scene& scene, const Stream& random) const;

 private:
  /// The window of the impacts alone, with the mean square 1.
  struct Synthesised {
    Eigen::ArrayXd window;
    std::vector<double> impact_times_s;
  };

  [[nodiscard]] std::vector<impacts::Impact> draw_impacts(const Scene& scene,
                                                          const Stream& random) const;

  [[nodiscard]] Synthesised synthesise(const Scene& scene, const Eigen::ArrayXcd& response,
                                       const Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd background(const Scene& scene, const Eigen::ArrayXcd& response,
                                          const Stream& random) const;

  const Machine& machine_;
  Prior prior_;
  double frame_s_;
};

}  // namespace piae::zero
