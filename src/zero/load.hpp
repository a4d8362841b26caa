#pragma once

#include <vector>

#include "base/random.hpp"
#include "bearing/kinematics.hpp"
#include "transfer/excitation.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// How the load on the ball that strikes comes and goes.
struct Load {
  double extent = 0;     ///< of the load zone (bearing/load_zone.hpp); 0: all are loaded alike
  double angle_rad = 0;  ///< of the defect from the direction of the load, at time 0
  double rad_per_s = 0;  ///< how fast it goes round
  double rotating = 0;   ///< load that turns with the shaft / load that stays
  double shaft_angle_rad = 0;  ///< at time 0
  double shaft_rad_per_s = 0;

  /// Q(t) = q(angle + rad_per_s t) (1 + rotating cos(shaft angle + shaft speed t)).
  [[nodiscard]] double at(double time_s) const;
};

/// A defect of the inner race passes the load zone with the shaft, one of a ball with the cage
/// (McFadden and Smith 1984); one of the outer race stays within the prior's angle of the load. The
/// extent of the zone is log-uniform. A load that turns with the shaft, such as that of an
/// unbalance, stands still for the inner race, and is uniform up to the prior's for the others.
Load draw_load(bearing::Defect defect, const bearing::Speeds& speeds, const Prior& prior,
               Stream& random);

/// Multiplies strengths by the load at their times, and each by exp(s) with s normal. Its standard
/// deviation is uniform up to the prior's.
void apply_load(const Load& load, const Prior& prior, Stream& random,
                std::vector<transfer::Strike>& strikes);

}  // namespace piae::zero
