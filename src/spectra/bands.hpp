#pragma once

#include <Eigen/Core>
#include <vector>

namespace piae::spectra {

/// A band of frequencies.
struct Band {
  double low_hz = 0;
  double high_hz = 0;
};

/// The bands that are demodulated, each by itself: 1200 Hz wide, every 600 Hz from 300 Hz on, up to
/// nine, the last from 5100 to 6300 Hz. An impact makes structures ring somewhere there; in which
/// band is not known before a fault was seen, so all count alike. A band is left out where its
/// middle lies above half the sample rate: there are nine at 12 kHz and none below 1800 Hz.
std::vector<Band> narrow_bands(double rate_hz);

/// The amplitude at each of the frequencies 0, bin_hz, 2 bin_hz, ... that a band lets through: 1
/// within, 0 outside, and sin^2 over 100 Hz about either edge.
Eigen::ArrayXd response(const Band& band, Eigen::Index bins, double bin_hz);

/// The narrow bands as they act on windows of one length and sample rate. To compute their
/// responses takes about as long as to use them, so who looks at many windows does it once.
struct FilterBank {
  double rate_hz = 0;
  std::vector<Eigen::ArrayXd> responses;  ///< of each band, at the bins 0 .. length / 2
};

/// For windows of `length` samples.
FilterBank filter_bank(double rate_hz, Eigen::Index length);

/// Returns the mean power in each band. Band b holds the bins edges[b] .. edges[b + 1] - 1.
Eigen::ArrayXd band_means(const Eigen::ArrayXd& power, const std::vector<Eigen::Index>& edges);

/// The bands of a spectrum's shape.
inline constexpr Eigen::Index spectral_shape_bands = 48;

/// The mean power of one window in 48 bands of equal width between 1/60 and 59/60 of half the
/// sample rate (100 to 5900 Hz at 12 kHz), in dB, less its mean over the bands: the shape of the
/// spectrum, not how loud it is. The window is tapered by Hann's window. Throws Error(bad_input)
/// for a window so short (some 100 samples) that a band holds no frequency.
Eigen::ArrayXd spectral_shape_db(const Eigen::RowVectorXd& window);

/// The power of one window in each band of a bank by that of the whole window, in dB. The bank is
/// one for windows of this length.
Eigen::ArrayXd band_levels_db(const Eigen::RowVectorXd& window, const FilterBank& bank);

}  // namespace piae::spectra
