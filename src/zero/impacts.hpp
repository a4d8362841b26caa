#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "bearing/kinematics.hpp"
#include "impacts/strengths.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// Returns the kinematic rate (eqs 5 to 7) times 1 + slip; the period is in s (Randall and Antoni
/// 2011: 1 to 2 %). The jitter is log-uniform from a seventh of the prior's to the prior's.
impacts::ImpactRate draw_rate(const Scene& scene, double slip, const Prior& prior, Stream& random);

/// Returns a load whose zone has a log-uniform extent. A defect of the outer race lies within the
/// prior's angle of the load; other defects start at any angle. The load that turns with the shaft
/// is uniform up to the prior's.
impacts::Load draw_load(bearing::Defect defect, const bearing::Speeds& speeds, const Prior& prior,
                        Stream& random);

/// Returns the largest size of a defect that is drawn, in mm: the prior's, limited to half a ball.
/// A ball would roll out of a larger defect on the side where it came in.
double largest_size_mm(const bearing::Geometry& geometry, const Prior& prior);

/// Returns the time between both edges of a defect, in s. The size is log-uniform. The passage time
/// (eq. 8, bearing/impact_frequency.hpp) is multiplied by a factor that is uniform from 0.8 to 1,
/// since a ball reaches the second edge before its centre does.
double draw_lag_s(const Scene& scene, const bearing::Geometry& geometry, const Prior& prior,
                  Stream& random);

/// Gives each impact its second edge (impacts/edges.hpp; Epps 1991, Sawalhi and Randall 2011). The
/// ratio of its strength to that of the first edge is uniform from the prior's to 1. The lag varies
/// from impact to impact by 5 %.
void add_second_edges(double lag_s, const Prior& prior, Stream& random,
                      std::vector<impacts::Impact>& impacts);

/// Returns the effect of the rough floor of a defect, in a frame of `samples`: noise while a ball
/// is on the floor. The root of the ratio of its energy to that of the impact's first edge is
/// log-uniform from 0.14 to 2.8.
Eigen::ArrayXd draw_rough_floor(const std::vector<impacts::Impact>& impacts, double lag_s,
                                Eigen::Index samples, double rate_hz, Stream& random);

}  // namespace piae::zero
