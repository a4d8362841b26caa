#pragma once

namespace piae::bearing {

/// The load of a ball as a share of the largest, `angle_rad` from the direction of the load
/// (Stribeck; Harris 2001, Section 7.3, point contact):
///   Q / Q_max = (1 - (1 - cos angle) / (2 extent))^1.5, and 0 outside the load zone.
/// An extent of 0.5 loads the balls of half a turn, as without clearance; clearance makes it
/// smaller, preload larger. From 1 on every ball carries some load. It must be positive.
double load_share(double angle_rad, double extent);

}  // namespace piae::bearing
