#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "transfer/excitation.hpp"
#include "zero/machine.hpp"
#include "zero/prior.hpp"

namespace piae::zero {

// What is no sign of a defect, and yet is heard.

/// What a window is multiplied by, sample by sample: 1 + the sum of what balls that pass one behind
/// the other, waviness of the races and unbalance do, whatever is damaged. BPFO, BPFI, the shaft's
/// speed and 2 BSF each do so with the probability 0.7, at a rate of their own slip, with a depth
/// that is log-uniform from a tenth of the prior's on, and two harmonics. Never negative.
Eigen::ArrayXd draw_modulation(const Scene& scene, const bearing::Geometry& geometry,
                               std::size_t samples, double rate_hz, const Prior& prior,
                               Stream& random);

/// Knocks of the rig in a frame, at any time and either way: with the prior's probability one, and
/// two more on average; else none. Their strengths are log-normal.
std::vector<transfer::Strike> draw_stray_knocks(double frame_s, const Prior& prior, Stream& random);

}  // namespace piae::zero
