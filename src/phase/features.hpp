#pragma once

#include <span>
#include <vector>

namespace piae::phase {

/// (k~, c~) is inferred from the autocorrelation at the lags from 1 to this number of samples.
inline constexpr std::size_t feature_lags = 256;

/// Returns features of a window that depend on stiffness and damping but not on its start angle:
/// the autocorrelation of its deviation from the mean, at lags 1 .. feature_lags, divided by that
/// at lag 0. After an impact, a resonance rings with exp(-c t / 2M) cos(sqrt(k / M) t), and its
/// autocorrelation has that form too. White measurement noise only scales it down. The window must
/// be longer than feature_lags and not constant.
std::vector<float> autocorrelation(std::span<const float> window);

}  // namespace piae::phase
