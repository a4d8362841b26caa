#include "transfer/known_edges.hpp"

#include <cmath>

#include "bearing/strikes.hpp"
#include "transfer/bearings.hpp"

namespace piae::transfer {

namespace {

constexpr double band_from = 0.02;
constexpr double band_to = 0.91;

SeenBearing seen(const signal::WindowSet& known, const KnownBearing& bearing) {
  const bearing::LocalDefect defect{.kind = known.info.class_of(bearing.label).defect,
                                    .size_mm = bearing.size_mm};
  return {.log_amplitude = log_amplitude(known, bearing),
          .passage_s = bearing::passage_s(known.info.bearing, defect, bearing.speed_rpm)};
}

Band band_of(const signal::WindowSet& known) {
  const auto bins = static_cast<double>(known.length);
  return {.bin_hz = known.info.sample_rate_hz / 2 / bins,
          .first = std::lround(band_from * bins),
          .last = std::lround(band_to * bins)};
}

}  // namespace

std::vector<Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior) {
  const std::vector<KnownBearing> bearings = bearings_of(known);
  std::vector<SeenBearing> all;
  for (const KnownBearing& bearing : bearings) all.push_back(seen(known, bearing));
  const std::vector<Edges> found = fit_edges(all, band_of(known), prior);
  std::vector<Edges> edges(known.size());
  for (std::size_t b = 0; b < bearings.size(); ++b) {
    for (const std::size_t i : bearings[b].windows) edges[i] = found[b];
  }
  return edges;
}

}  // namespace piae::transfer
