#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "bearing/kinematics.hpp"
#include "impacts/strengths.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

/// The kinematic rate (eqs 5 to 7) by 1 + slip, in s (Randall and Antoni 2011: 1 to 2 %). The
/// jitter is log-uniform from a seventh of the prior's on.
impacts::ImpactRate draw_rate(const Scene& scene, double slip, const Prior& prior, Stream& random);

/// A load whose zone has a log-uniform extent. A defect of the outer race stays within the prior's
/// angle of the load, others begin anywhere. The load that turns with the shaft is uniform up to
/// the prior's.
impacts::Load draw_load(bearing::Defect defect, const bearing::Speeds& speeds, const Prior& prior,
                        Stream& random);

/// The largest size of a defect that is drawn, in mm: the prior's, but no more than half a ball,
/// which would roll out of it on the way it came in.
double largest_size_mm(const bearing::Geometry& geometry, const Prior& prior);

/// How long a ball is between both edges of a defect, in s. The size is log-uniform, and the time
/// it takes to pass it (eq. 8, bearing/strikes.hpp) is times a part that is uniform from 0.8 to 1,
/// since a ball reaches the second edge before its centre does.
double draw_lag_s(const Scene& scene, const bearing::Geometry& geometry, const Prior& prior,
                  Stream& random);

/// Gives each impact its second edge (impacts/edges.hpp; Epps 1991, Sawalhi and Randall 2011). Its
/// strength / that of the first is uniform from the prior's to 1; the lag differs from impact to
/// impact by 5 %.
void add_second_edges(double lag_s, const Prior& prior, Stream& random,
                      std::vector<impacts::Impact>& impacts);

/// The floor of a defect, in a frame of `samples`: as long as a ball is on it, noise, whose energy
/// is that of the impact's first edge times a factor whose root is log-uniform from 0.14 to 2.8.
Eigen::ArrayXd draw_rough_floor(const std::vector<impacts::Impact>& impacts, double lag_s,
                                Eigen::Index samples, double rate_hz, Stream& random);

}  // namespace piae::zero
