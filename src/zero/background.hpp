#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "impacts/times.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

// All that a window shows whatever is damaged.

/// Knots of a random path, from 0 Hz to half the sampling rate: 0.75 kHz apart at 12 kHz.
inline constexpr int path_knots = 9;

/// A healthy window with the mean 0 and the mean square 1. Every second one, by chance, runs
/// backwards: it has the same spectrum then, and is not the same window. It goes through a random
/// smooth path (impacts/path.hpp) whose gain at a knot has this standard deviation.
Eigen::ArrayXd draw_background(std::span<const float> healthy, double spread_db, Stream& random);

/// A window at the level of the healthy one: the same standard deviation, and the mean 0. The level
/// of a fault is unknown, and classifiers standardise. A window in which nothing moves stays so.
std::vector<float> at_level_of(std::span<const float> healthy, const Eigen::ArrayXd& window);

/// Factor for each sample: 1 + the sum of what balls that pass one behind the other, waviness of
/// the races and unbalance do. BPFO, BPFI, the shaft's speed and 2 BSF each contribute with the
/// probability 0.7, at a rate of their own slip, with a depth that is log-uniform from a tenth of
/// the prior's on, and two harmonics. Never negative.
Eigen::ArrayXd draw_modulation(const Scene& scene, const bearing::Geometry& geometry,
                               std::size_t samples, double rate_hz, const Prior& prior,
                               Stream& random);

/// Impacts of the rig in a frame, at any time and of either sign: with the prior's probability one,
/// and two more on average; else none. Their strengths are log-normal.
std::vector<impacts::Impact> draw_stray_knocks(double frame_s, const Prior& prior, Stream& random);

}  // namespace piae::zero
