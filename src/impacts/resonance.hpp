#pragma once

#include <Eigen/Core>
#include <vector>

#include "signal/recordings.hpp"

namespace piae::impacts {

/// Returns the response of eq. 13 without contacts to one impact, M x'' + c x' + k x = F: the
/// logarithm of the amplitude of its acceleration, w^2 / |k - M w^2 + i w c|, at `bins` frequencies
/// from 0 Hz to half the sampling rate, with the mean 0. The value at 0 Hz is that of the next bin.
Eigen::ArrayXd ring_response(const signal::DynamicParameters& ring, double mass_kg,
                             Eigen::Index bins, double rate_hz);

/// Returns k and c of the strongest resonance in a response of that form: w^2 = k / M at its peak,
/// and c = M times the half-power width in rad/s.
signal::DynamicParameters strongest_ring(const Eigen::ArrayXd& log_response, double mass_kg,
                                         double rate_hz);

/// One resonance of the structure between a defect and the sensor.
struct Resonance {
  double natural_hz = 0;
  double damping_ratio = 0;
  double height = 0;  ///< height of its peak, with a sign
};

/// Returns the amplitude of the sum of resonances at `bins` frequencies from 0 Hz to half the
/// sampling rate, each of the form of ring_response():
///  sum of height 2 zeta w^2 / (w_n^2 - w^2 + 2 i zeta w_n w).
Eigen::ArrayXd amplitude(const std::vector<Resonance>& resonances, Eigen::Index bins,
                         double rate_hz);

/// Returns k and c of the resonance with the highest peak: w_n^2 = k / M, 2 zeta w_n = c / M.
signal::DynamicParameters ring_of(const std::vector<Resonance>& resonances, double mass_kg);

}  // namespace piae::impacts
