#pragma once

#include <Eigen/Core>

namespace piae::spectra {

/// Windows, a row for each: [n, length], in the unit of the recordings.
using Windows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Hann's window in the periodic form, which is usual in spectral estimates.
Eigen::RowVectorXd hann(Eigen::Index length);

/// Mean power of each frequency bin 0 .. length / 2 over all windows. This is Welch's estimate
/// (1967) with the windows as its segments: the mean of each is removed, and it is tapered by
/// Hann's window. It is not scaled to a density, since only ratios are used. With `padding` above
/// 1, zeros are appended to that many times the length; the bins are then 0 .. padding * length /
/// 2, and closer.
Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Eigen::Index padding = 1);

/// The power of one window by time and frequency: [times, segment / 2 + 1]. The window is cut into
/// segments of `segment` samples, each of which begins half of one after the one before, and of
/// each the power spectrum is taken as mean_power_spectrum() does (mean removed, Hann's window, not
/// scaled). What a last segment would lack is left out. Throws std::logic_error for segments that
/// are shorter than 2, odd, or longer than the window.
Eigen::ArrayXXd spectrogram(const Eigen::Ref<const Eigen::RowVectorXd>& window,
                            Eigen::Index segment);

/// The Hilbert envelope of each window, which is the magnitude of its analytic signal; the window's
/// mean is removed first. The whole band is demodulated, so that there is no band to choose. This
/// is envelope analysis of the raw signal, the first method of Smith and Randall (2015). The
/// envelope is not squared: in a squared one a single impact of high level would hide the others.
Windows envelopes(const Windows& windows);

}  // namespace piae::spectra
