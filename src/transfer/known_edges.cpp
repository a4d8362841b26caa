#include "transfer/known_edges.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "bearing/strikes.hpp"
#include "scoring/spectrum.hpp"

namespace piae::transfer {

namespace {

using Eigen::Index;

constexpr Index pieces_in_half = 4;  ///< a piece begins each quarter of its length
constexpr Index padding = 2;
constexpr double band_from = 0.02;
constexpr double band_to = 0.91;

/// The indices of its windows by class, speed and size.
using Bearings = std::map<std::tuple<Label, double, double>, std::vector<std::size_t>>;

Bearings bearings_of(const signal::WindowSet& known) {
  Bearings bearings;
  for (std::size_t i = 0; i < known.size(); ++i) {
    bearings[{known.labels[i], known.speed_rpm(i), known.size_mm(i)}].push_back(i);
  }
  return bearings;
}

/// Pieces of half a window, a row for each.
scoring::Windows pieces_of(const signal::WindowSet& known, const std::vector<std::size_t>& own) {
  const auto length = static_cast<Index>(known.length / 2);
  const Index step = length / pieces_in_half;
  const Index in_a_window = pieces_in_half + 1;
  scoring::Windows pieces(static_cast<Index>(own.size()) * in_a_window, length);
  Index row = 0;
  for (const std::size_t i : own) {
    const Eigen::Map<const Eigen::RowVectorXf> window(known.window(i).data(),
                                                      static_cast<Index>(known.length));
    for (Index j = 0; j < in_a_window; ++j) {
      pieces.row(row++) = window.segment(j * step, length).cast<double>();
    }
  }
  return pieces;
}

SeenBearing seen_bearing(const signal::WindowSet& known, const std::vector<std::size_t>& own) {
  const std::size_t first = own.front();
  const bearing::LocalDefect defect{.kind = known.info.class_of(known.labels[first]).defect,
                                    .size_mm = known.size_mm(first)};
  const Eigen::ArrayXd power = scoring::mean_power_spectrum(pieces_of(known, own), padding);
  const double silence = std::numeric_limits<double>::min();
  return {.log_amplitude = (power + silence).log() / 2,
          .passage_s = bearing::passage_s(known.info.bearing, defect, known.speed_rpm(first))};
}

Band band_of(const signal::WindowSet& known) {
  const auto bins = static_cast<double>(padding * static_cast<Index>(known.length / 2) / 2);
  return {.bin_hz = known.info.sample_rate_hz / 2 / bins,
          .first = std::lround(band_from * bins),
          .last = std::lround(band_to * bins)};
}

}  // namespace

std::vector<Edges> edges_of_known(const signal::WindowSet& known, const EdgePrior& prior) {
  const Bearings bearings = bearings_of(known);
  std::vector<SeenBearing> seen;
  for (const auto& [what, own] : bearings) seen.push_back(seen_bearing(known, own));
  const std::vector<Edges> found = fit_edges(seen, band_of(known), prior);
  std::vector<Edges> edges(known.size());
  auto next = found.begin();
  for (const auto& [what, own] : bearings) {
    for (const std::size_t i : own) edges[i] = *next;
    ++next;
  }
  return edges;
}

}  // namespace piae::transfer
