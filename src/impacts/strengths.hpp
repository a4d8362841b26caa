#pragma once

#include <array>
#include <vector>

#include "base/random.hpp"
#include "bearing/defect.hpp"
#include "bearing/kinematics.hpp"
#include "cli/stored_options.hpp"
#include "impacts/times.hpp"

namespace piae::impacts {

/// Returns the load of a ball as a fraction of the largest, `angle_rad` from the direction of the
/// load (Stribeck; Harris 2001, Section 7.3, point contact):
///   Q / Q_max = (1 - (1 - cos angle) / (2 extent))^1.5, and 0 outside the load zone.
/// An extent of 0.5 loads the balls of half a turn, as without clearance. Clearance makes the
/// extent smaller, preload larger. From 1 on, every ball carries some load. `extent` must be
/// positive.
double load_share(double angle_rad, double extent);

/// Ranges from which a load is drawn.
struct LoadOptions {
  double least_extent = 0;  ///< extent of the load zone
  double largest_extent = 0;
  double rotating = 0;  ///< load that turns with the shaft / load that stays: largest ratio
  double scatter = 0;   ///< largest standard deviation of the logarithm of an impact's strength
};

/// Adds --load-zone-from, --load-zone-to, --rotating-load and --strength-scatter. `stored` names
/// their attributes where these differ from the option names.
void add_to(cli::StoredOptions& table, LoadOptions& options,
            const std::array<const char*, 4>& stored = {"", "", "", ""});

/// Load on the ball that meets a defect.
struct Load {
  double extent = 0;           ///< extent of the load zone; 0: the load is the same everywhere
  double angle_rad = 0;        ///< angle from the direction of the load to the defect, at time 0
  double rad_per_s = 0;        ///< speed of the defect about the bearing's axis
  double rotating = 0;         ///< load that turns with the shaft / load that stays
  double shaft_angle_rad = 0;  ///< at time 0
  double shaft_rad_per_s = 0;

  /// Returns Q(t) = q(angle + rad_per_s t) (1 + rotating cos(shaft angle + shaft speed t)).
  [[nodiscard]] double at(double time_s) const;
};

/// Returns the speed of a defect and its part of a load that turns with the shaft, such as that of
/// an unbalance. A defect of the inner race passes the load zone with the shaft, so a turning load
/// is constant for it. A defect of a ball passes with the cage (McFadden and Smith 1984). A defect
/// of the outer race stays. All other members are 0.
Load load_on(bearing::Defect defect, const bearing::Speeds& speeds, double rotating);

/// Multiplies strengths by the load at their times and by exp(s), where s is normal with this
/// standard deviation.
void apply_load(const Load& load, double scatter, Stream& random, std::vector<Impact>& impacts);

/// Multiplies the strength of every second impact, from `first` on. A ball's defect hits both races
/// alternately, and the path to the sensor is longer from one of them.
void weaken_every_second(double factor, std::size_t first, std::vector<Impact>& impacts);

}  // namespace piae::impacts
