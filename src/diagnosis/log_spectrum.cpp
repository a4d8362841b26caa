#include "diagnosis/log_spectrum.hpp"

#include <cmath>

#include "spectra/power.hpp"

namespace piae::diagnosis {

double root_mean_square(const scoring::Windows& window) {
  return std::sqrt((window.array() - window.mean()).square().mean());
}

Eigen::ArrayXd log_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                            double floor) {
  const Eigen::Index length = window.cols();
  Eigen::Index padding = 1;
  while (padding * length / 2 < least_bands) ++padding;
  const Eigen::ArrayXd power =
      spectra::mean_power_spectrum(window, padding).tail(padding * length / 2);
  return (4 / static_cast<double>(length) * power.sqrt()).max(floor).log();
}

Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor) {
  return log_spectrum(spectra::envelopes(window), least_bands, floor);
}

}  // namespace piae::diagnosis
