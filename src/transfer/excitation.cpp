#include "transfer/excitation.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace piae::transfer {

namespace {

/// Adds a blow. From bin to bin its phase turns by one angle, so no sine is needed at each.
void add_blow(double strength, double time_s, double bin_hz, Eigen::ArrayXcd& spectrum) {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * bin_hz * time_s);
  std::complex<double> blow = strength;
  for (std::complex<double>& bin : spectrum) {
    bin += blow;
    blow *= turn;
  }
}

}  // namespace

Eigen::ArrayXcd excitation(const std::vector<Strike>& strikes, Eigen::Index bins, double bin_hz) {
  Eigen::ArrayXcd spectrum = Eigen::ArrayXcd::Zero(bins);
  for (const Strike& strike : strikes) {
    add_blow(strike.strength, strike.time_s, bin_hz, spectrum);
    add_blow(-strike.strength * strike.exit, strike.time_s + strike.lag_s, bin_hz, spectrum);
  }
  return spectrum;
}

}  // namespace piae::transfer
