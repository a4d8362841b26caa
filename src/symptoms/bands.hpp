#pragma once

#include <Eigen/Core>
#include <vector>

namespace piae::symptoms {

/// A band of frequencies.
struct Band {
  double low_hz = 0;
  double high_hz = 0;
};

/// The bands that are demodulated, each by itself: 1200 Hz wide, every 600 Hz from 300 Hz on, up to
/// nine, the last from 5100 to 6300 Hz. A blow makes structures ring somewhere there; in which band
/// is not known before a fault was heard, so all count alike. A band is left out where its middle
/// lies above half the sample rate: there are nine at 12 kHz and none below 1800 Hz.
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

}  // namespace piae::symptoms
