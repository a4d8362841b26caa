#include "transfer/known_edges.hpp"

#include <cmath>

#include "transfer/bearings.hpp"
#include "transfer/kinematics.hpp"

namespace piae::transfer {

namespace {

constexpr double band_from = 0.02;
constexpr double band_to = 0.91;

SeenBearing seen(const signal::WindowSet& known, const KnownBearing& bearing) {
  return {
      .log_amplitude = log_amplitude(known, bearing),
      .passage_s = passage_s(known, bearing.windows.front(), bearing.size_mm, bearing.speed_rpm)};
}

Band band_of(const signal::WindowSet& known) {
  const auto bins = static_cast<double>(known.length + known.length % 2);
  return {.bin_hz = known.info.sample_rate_hz / 2 / bins,
          .first = std::lround(band_from * bins),
          .last = std::lround(band_to * bins)};
}

}  // namespace

std::vector<Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior) {
  const std::vector<KnownBearing> bearings = bearings_of(known);
  std::vector<SeenBearing> all;
  all.reserve(bearings.size());
  for (const KnownBearing& bearing : bearings) all.push_back(seen(known, bearing));
  const std::vector<Edges> found = fit_edges(all, band_of(known), prior);
  std::vector<Edges> edges(known.size());
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    for (const std::size_t i : bearings[b].windows) edges[i] = found[b];
  }
  return edges;
}

}  // namespace piae::transfer
