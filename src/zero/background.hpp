#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

// Everything that a window shows independently of a fault.

/// Knots of a random path, from 0 Hz to half the sampling rate: 0.75 kHz apart at 12 kHz.
inline constexpr int path_knots = 9;

/// Returns a healthy window with the mean 0 and the mean square 1. Reverses it in time with
/// probability 1/2: a reversed window has the same spectrum but different samples. Filters it by a
/// random smooth path (impacts/path.hpp) whose gain at a knot has this standard deviation.
Eigen::ArrayXd draw_background(std::span<const float> healthy, double spread_db, Stream& random);

/// Returns a window at the level of the healthy one: the same standard deviation, and the mean 0.
/// The level of a fault is unknown, and classifiers standardise their inputs. A constant window
/// stays constant.
std::vector<float> at_level_of(std::span<const float> healthy, const Eigen::ArrayXd& window);

/// Returns a factor for each sample: 1 plus a sum of cosines. The sum models the effects of
/// successive ball passes, of waviness of the races and of unbalance. BPFO, BPFI, the shaft's speed
/// and 2 BSF each contribute with the probability 0.7, with two harmonics. Each has its own slip,
/// except the shaft, and a log-uniform depth from a tenth of the prior's to the prior's. The factor
/// is never negative.
Eigen::ArrayXd draw_modulation(const Scene& scene, const bearing::Geometry& geometry,
                               std::size_t samples, double rate_hz, const Prior& prior,
                               Stream& random);

/// Returns impacts of the rig at random times of a frame, with random sign. There are impacts with
/// the prior's probability: one, and two more on average. Their strengths are log-normal.
std::vector<impacts::Impact> draw_stray_impacts(double frame_s, const Prior& prior, Stream& random);

}  // namespace piae::zero
