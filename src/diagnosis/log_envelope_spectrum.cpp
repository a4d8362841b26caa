#include "diagnosis/log_envelope_spectrum.hpp"

#include "diagnosis/log_spectrum.hpp"
#include "scoring/envelope.hpp"

namespace piae::diagnosis {

Eigen::ArrayXd log_envelope_spectrum(const scoring::Windows& window, Eigen::Index least_bands,
                                     double floor) {
  return log_spectrum(scoring::envelopes(window), least_bands, floor);
}

}  // namespace piae::diagnosis
