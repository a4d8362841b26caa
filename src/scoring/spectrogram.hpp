#pragma once

#include "scoring/windows.hpp"

namespace piae::scoring {

/// The power of one window by time and frequency: [times, segment / 2 + 1]. The window is cut into
/// segments of `segment` samples, each of which begins half of one after the one before, and of
/// each the power spectrum is taken as mean_power_spectrum() does (mean removed, Hann's window, not
/// scaled). What a last segment would lack is left out. Throws std::logic_error for segments that
/// are shorter than 2, odd, or longer than the window.
Eigen::ArrayXXd spectrogram(const Eigen::Ref<const Eigen::RowVectorXd>& window,
                            Eigen::Index segment);

}  // namespace piae::scoring
