#include "phase/alignment.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace piae::phase {

namespace {

using Eigen::Index;
using Map = Eigen::Map<const Eigen::VectorXd>;

struct Fit {
  std::size_t start = 0;
  double correlation = -std::numeric_limits<double>::infinity();
};

Fit best_fit(std::span<const double> reference, std::span<const double> waveform) {
  const auto samples = static_cast<Index>(reference.size());
  Eigen::VectorXd twice(2 * samples);
  twice << Map(reference.data(), samples), Map(reference.data(), samples);
  const Map target(waveform.data(), samples);
  Fit fit;
  for (Index s = 0; s < samples; ++s) {
    const double correlation = twice.segment(s, samples).dot(target);
    if (correlation > fit.correlation) {
      fit = {.start = static_cast<std::size_t>(s), .correlation = correlation};
    }
  }
  fit.correlation /= Map(reference.data(), samples).norm() * target.norm();
  return fit;
}

}  // namespace

std::size_t infer_start(std::span<const double> reference, std::span<const double> waveform) {
  return best_fit(reference, waveform).start;
}

Alignment align(const std::vector<std::vector<double>>& waveforms) {
  Alignment best;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t reference = 0; reference < waveforms.size(); ++reference) {
    Alignment alignment{.reference = reference, .starts = {}};
    double sum = 0;
    for (const std::vector<double>& waveform : waveforms) {
      const Fit fit = best_fit(waveforms[reference], waveform);
      alignment.starts.push_back(fit.start);
      sum += fit.correlation;
    }
    if (sum > largest) {
      largest = sum;
      best = alignment;
    }
  }
  return best;
}

}  // namespace piae::phase
