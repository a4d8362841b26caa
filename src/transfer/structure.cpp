#include "transfer/structure.hpp"

#include <cmath>

#include "impacts/response.hpp"
#include "transfer/known_bearings.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Fraction of the time between impacts for which the structure may ring; longer ringing is not
/// observable.
constexpr double seen_part = 0.8;

/// Least divisor: at smaller E the spectrum shows noise instead of the structure.
constexpr double least_gain = 0.1;

ArrayXd without_edges(ArrayXd log_amplitude, const impacts::Edges& edges, double bin_hz) {
  for (Index i = 0; i < log_amplitude.size(); ++i) {
    const double gain = edges.amplitude(static_cast<double>(i) * bin_hz);
    log_amplitude[i] -= std::log(std::max(gain, least_gain));
  }
  return log_amplitude;
}

ArrayXd response_of(const signal::WindowSet& known, const KnownBearing& bearing,
                    const impacts::Edges& edges) {
  const double rate_hz = known.info.sample_rate_hz;
  const double bin_hz = rate_hz / 2 / static_cast<double>(known.length);
  const ArrayXd response = impacts::liftered(
      without_edges(impacts::log_amplitude(known, bearing.windows), edges, bin_hz),
      seen_part * rate_hz * period_s(known, bearing.windows.front(), bearing.speed_rpm));
  return response - response.mean();
}

}  // namespace

Structure structure_of(const signal::WindowSet& known, const std::vector<impacts::Edges>& edges) {
  const std::vector<KnownBearing> bearings = bearings_of(known);
  std::vector<ArrayXd> responses;
  responses.reserve(bearings.size());
  for (const KnownBearing& bearing : bearings) {
    responses.push_back(response_of(known, bearing, edges[bearing.windows.front()]));
  }
  Structure structure{.common = ArrayXd::Zero(responses.front().size()),
                      .own = std::vector<ArrayXd>(known.size())};
  for (const ArrayXd& response : responses) structure.common += response;
  structure.common /= static_cast<double>(responses.size());
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    for (const std::size_t i : bearings[b].windows) {
      structure.own[i] = responses[b] - structure.common;
    }
  }
  return structure;
}

}  // namespace piae::transfer
