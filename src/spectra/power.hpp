#pragma once

#include <Eigen/Core>

namespace piae::spectra {

/// Windows, one per row: [n, length], in the unit of the recordings.
using Windows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns Hann's window in its periodic form, which is usual in spectral estimates.
Eigen::RowVectorXd hann(Eigen::Index length);

/// Returns the mean power of each frequency bin 0 .. length / 2 over all windows. This is Welch's
/// estimate (1967) with the windows as its segments: the mean of each is removed, and it is tapered
/// by Hann's window. The result is not scaled to a density, since only ratios are used. `padding`
/// above 1 appends zeros up to that multiple of the length; the bins are then 0 .. padding * length
/// / 2, with a finer spacing.
Eigen::ArrayXd mean_power_spectrum(const Windows& windows, Eigen::Index padding = 1);

/// Returns the power of one window by time and frequency: [times, segment / 2 + 1]. Segments of
/// `segment` samples overlap by half. Each segment's power spectrum is that of
/// mean_power_spectrum() (mean removed, Hann's window, not scaled). Samples that do not fill a last
/// segment are ignored. Throws std::logic_error if segments are shorter than 2, odd, or longer than
/// the window.
Eigen::ArrayXXd spectrogram(const Eigen::Ref<const Eigen::RowVectorXd>& window,
                            Eigen::Index segment);

/// Returns the Hilbert envelope of each window: the magnitude of its analytic signal, after its
/// mean is removed. Demodulates the whole band, so no band has to be chosen. This is
/// envelope analysis of the raw signal, the first method of Smith and Randall (2015). The envelope
/// is not squared: in a squared envelope a single strong impact would hide the others.
Windows envelopes(const Windows& windows);

}  // namespace piae::spectra
