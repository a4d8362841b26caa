#include <cmath>
#include <complex>
#include <numbers>

#include "impacts/synthesis.hpp"

namespace piae::impacts {

namespace {

/// Adds one impulse. Rotates its phase by the same angle from bin to bin, which avoids a sine per
/// bin.
void add_impulse(double strength, double time_s, double bin_hz, Eigen::ArrayXcd& spectrum) {
  const std::complex<double> turn = std::polar(1.0, -2 * std::numbers::pi * bin_hz * time_s);
  std::complex<double> impulse = strength;
  for (std::complex<double>& bin : spectrum) {
    bin += impulse;
    impulse *= turn;
  }
}

}  // namespace

Eigen::ArrayXcd excitation(const std::vector<Impact>& impacts, Eigen::Index bins, double bin_hz) {
  Eigen::ArrayXcd spectrum = Eigen::ArrayXcd::Zero(bins);
  for (const Impact& impact : impacts) {
    add_impulse(impact.strength, impact.time_s, bin_hz, spectrum);
    add_impulse(-impact.strength * impact.exit, impact.time_s + impact.lag_s, bin_hz, spectrum);
  }
  return spectrum;
}

}  // namespace piae::impacts
