#pragma once

#include <span>
#include <vector>

namespace piae::phase {

/// (k~, c~) is inferred from the autocorrelation at the lags from 1 to this number of samples.
inline constexpr std::size_t feature_lags = 256;

/// The features of a window that show stiffness and damping but do not change with the angle at
/// which it starts: the autocorrelation of its deviation from the mean, at lags 1 .. feature_lags,
/// divided by that at lag 0. A ring that was struck answers with exp(-c t / 2M) cos(sqrt(k / M) t),
/// and its autocorrelation has that form too; white measurement noise only scales it down. The
/// window must be longer than feature_lags and not constant.
std::vector<float> autocorrelation(std::span<const float> window);

}  // namespace piae::phase
