#include "impacts/synthesis.hpp"

#include <cmath>

#include "impacts/response.hpp"

namespace piae::impacts {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

double bin_hz_of(Index bins, double rate_hz) { return rate_hz / 2 / static_cast<double>(bins - 1); }

}  // namespace

ArrayXd impact_frame(const std::vector<Impact>& impacts, const ArrayXcd& response, double rate_hz) {
  const Index bins = response.size();
  return samples_of(response * excitation(impacts, bins, bin_hz_of(bins, rate_hz)));
}

ArrayXd window_of(const ArrayXd& frame, std::size_t length) {
  const ArrayXd window = frame.tail(static_cast<Index>(length));
  const double power = window.square().mean();
  return power > 0 ? ArrayXd(window / std::sqrt(power)) : window;
}

ArrayXd noise_window(const ArrayXd& log_response, const Edges& edges, double rate_hz,
                     Stream& random) {
  const double bin_hz = bin_hz_of(log_response.size(), rate_hz);
  ArrayXcd spectrum(log_response.size());
  for (Index i = 0; i < spectrum.size(); ++i) {
    const double amplitude =
        std::exp(log_response[i]) * edges.amplitude(static_cast<double>(i) * bin_hz);
    const double real = random.normal(0, amplitude);
    spectrum[i] = {real, random.normal(0, amplitude)};
  }
  return window_of(samples_of(spectrum), static_cast<std::size_t>(spectrum.size() - 1));
}

}  // namespace piae::impacts
