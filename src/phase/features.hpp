#pragma once

#include <span>
#include <vector>

namespace piae::phase {

/// Lags of the autocorrelation that infer (k~, c~): 1 .. 256 samples.
inline constexpr std::size_t feature_lags = 256;

/// What of a window shows stiffness and damping and does not change with its start angle: the
/// autocorrelation of its deviation from the mean, at lags 1 .. feature_lags, divided by that at
/// lag 0. A struck ring answers with exp(-c t / 2M) cos(sqrt(k / M) t), and so does its
/// autocorrelation; white measurement noise only lowers it as a whole. The window is longer than
/// feature_lags and not constant.
std::vector<float> autocorrelation(std::span<const float> window);

}  // namespace piae::phase
