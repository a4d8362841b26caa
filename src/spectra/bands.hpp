#pragma once

#include <Eigen/Core>
#include <vector>

namespace piae::spectra {

/// A band of frequencies.
struct Band {
  double low_hz = 0;
  double high_hz = 0;
};

/// Returns the bands that are demodulated separately: 1200 Hz wide, every 600 Hz from 300 Hz on, up
/// to nine (the last from 5100 to 6300 Hz). An impact excites structures in some of these bands.
/// The band is unknown before a fault was seen, so all bands count equally. Leaves out bands whose
/// middle lies above half the sample rate: 12 kHz gives nine bands, a rate below 1800 Hz gives
/// none.
std::vector<Band> narrow_bands(double rate_hz);

/// Returns the amplitude response of a band at the frequencies 0, bin_hz, 2 bin_hz, ...: 1 inside,
/// 0 outside, and sin^2 over 100 Hz about either edge.
Eigen::ArrayXd response(const Band& band, Eigen::Index bins, double bin_hz);

/// Responses of the narrow bands for windows of one length and sample rate. Computing them costs
/// about as much as using them once, so build the bank once for many windows.
struct FilterBank {
  double rate_hz = 0;
  std::vector<Eigen::ArrayXd> responses;  ///< response of each band, at the bins 0 .. length / 2
};

/// Returns the bank for windows of `length` samples.
FilterBank filter_bank(double rate_hz, Eigen::Index length);

/// Returns the mean power in each band. Band b covers the bins edges[b] .. edges[b + 1] - 1.
Eigen::ArrayXd band_means(const Eigen::ArrayXd& power, const std::vector<Eigen::Index>& edges);

/// Fraction of half the sample rate that a spectrum's shape leaves out at both ends.
inline constexpr double left_out_edge = 1.0 / 60;

/// Number of bands of a spectrum's shape.
inline constexpr Eigen::Index spectral_shape_bands = 48;

/// Returns the mean power of one window in 48 bands of equal width between 1/60 and 59/60 of half
/// the sample rate (100 to 5900 Hz at 12 kHz), in dB, minus its mean over the bands. So the result
/// describes the shape of the spectrum, not its level. The window is tapered by Hann's window.
/// Throws Error(bad_input) if the window is so short (below about 100 samples) that a band has no
/// bin.
Eigen::ArrayXd spectral_shape_db(const Eigen::RowVectorXd& window);

/// Returns the power of one window in each band of a bank divided by that of the whole window, in
/// dB. The bank must be for windows of this length.
Eigen::ArrayXd band_levels_db(const Eigen::RowVectorXd& window, const FilterBank& bank);

}  // namespace piae::spectra
