#include "transfer/edge_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"

namespace piae::transfer {
namespace {

constexpr Band band{.bin_hz = 12000.0 / 1024, .first = 10, .last = 465};

/// Returns the spectrum of a bearing with such edges on a resonant structure, with the scatter of
/// its windows and its own colour.
SeenBearing seen(const impacts::Edges& edges, double passage_s, double colour, Stream& random) {
  SeenBearing bearing;
  bearing.passage_s = passage_s;
  bearing.log_amplitude.resize(513);
  for (Eigen::Index i = 0; i < 513; ++i) {
    const double hz = static_cast<double>(i) * band.bin_hz;
    double structure = 1e-2;
    for (const double resonance : {700.0, 1450.0, 2600.0, 4100.0}) {
      structure += 1 / (1 + std::pow((hz - resonance) / 90, 2));
    }
    bearing.log_amplitude[i] = std::log(structure) + colour * hz / 6000 +
                               std::log(edges.amplitude(hz)) + random.normal(0, 0.15);
  }
  return bearing;
}

TEST(EdgeFit, SeparatesEdgesFromTheCommonStructure) {
  Stream random("bearings");
  const double passages_s[] = {0.4e-3, 0.7e-3, 1.1e-3, 1.6e-3};
  const double shares[] = {0.85, 0.95, 0.9, 0.8};
  const double exits[] = {0.5, 0.8, 0.65, 0.35};
  std::vector<SeenBearing> bearings;
  for (int b = 0; b < 4; ++b) {
    bearings.push_back(seen({.lag_s = shares[b] * passages_s[b], .exit = exits[b], .spread = 0.015},
                            passages_s[b], b - 1.5, random));
  }
  const std::vector<impacts::Edges> edges = fit_edges(bearings, band, {});
  for (std::size_t b = 0; b < 4; ++b) {
    EXPECT_NEAR(edges[b].lag_s / passages_s[b], shares[b], 0.021) << b;
    EXPECT_NEAR(edges[b].exit, exits[b], 0.16) << b;
  }
}

TEST(EdgeFit, OneBearingGivesThePrior) {
  Stream random("bearing");
  const SeenBearing bearing = seen({.lag_s = 0.8e-3, .exit = 0.8}, 1e-3, 0, random);
  const std::vector<impacts::Edges> edges = fit_edges({bearing}, band, {});
  EXPECT_NEAR(edges[0].lag_s, 0.9e-3, 1e-9);
  EXPECT_NEAR(edges[0].exit, 0.65, 1e-12);  // the point of the grid that is nearest to 0.6
}

TEST(EdgeFit, LagsWithoutAMinimumGiveAlmostThePrior) {
  Stream random("short");
  std::vector<SeenBearing> bearings;
  for (int b = 0; b < 4; ++b) {
    bearings.push_back(seen({.lag_s = 0.9 * 20e-6, .exit = 0.6}, 20e-6, b, random));
  }
  for (const impacts::Edges& edges : fit_edges(bearings, band, {})) {
    EXPECT_NEAR(edges.lag_s, 0.9 * 20e-6, 0.16 * 20e-6);
  }
}

}  // namespace
}  // namespace piae::transfer
