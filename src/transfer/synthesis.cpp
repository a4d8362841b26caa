#include "transfer/synthesis.hpp"

#include <cmath>
#include <complex>

#include "transfer/cepstrum.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

double bin_hz_of(Index bins, double rate_hz) { return rate_hz / 2 / static_cast<double>(bins - 1); }

ArrayXd second_half(const ArrayXcd& spectrum) {
  const ArrayXd window = samples_of(spectrum).tail(spectrum.size() - 1);
  const double power = window.square().mean();
  return power > 0 ? ArrayXd(window / std::sqrt(power)) : window;
}

}  // namespace

ArrayXd struck_window(const ArrayXd& log_answer, const Path& path,
                      const std::vector<Strike>& strikes, double rate_hz) {
  const Index bins = log_answer.size();
  const ArrayXcd turned =
      (std::complex<double>(0, 1) * path.phase.cast<std::complex<double>>()).exp();
  return second_half(minimum_phase(log_answer + path.log_gain) * turned *
                     excitation(strikes, bins, bin_hz_of(bins, rate_hz)));
}

ArrayXd background_window(const ArrayXd& log_answer, const Edges& edges, double rate_hz,
                          Stream& random) {
  const double bin_hz = bin_hz_of(log_answer.size(), rate_hz);
  ArrayXcd spectrum(log_answer.size());
  for (Index i = 0; i < spectrum.size(); ++i) {
    const double amplitude =
        std::exp(log_answer[i]) * edges.amplitude(static_cast<double>(i) * bin_hz);
    const double real = random.normal(0, amplitude);
    spectrum[i] = {real, random.normal(0, amplitude)};
  }
  return second_half(spectrum);
}

}  // namespace piae::transfer
