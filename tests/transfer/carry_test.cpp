#include "transfer/carry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "spectra/power.hpp"
#include "support/errors.hpp"
#include "transfer/carried.hpp"
#include "transfer/known_edges.hpp"

namespace piae::transfer {
namespace {

std::vector<impacts::Edges> true_edges(const signal::WindowSet& known) {
  std::vector<impacts::Edges> edges;
  for (std::size_t i = 0; i < known.size(); ++i) {
    edges.push_back(edges_at(known, i, lag_shares[i / 5], 1200));
  }
  return edges;
}

/// Returns the same machine, with tested bearings that differ from the known ones.
signal::WindowSet other_bearings_tested() {
  signal::WindowSet known = one_machine();
  for (std::size_t i = 0; i < known.size(); ++i) {
    known.defect_size_mm.push_back(known.info.class_of(known.labels[i]).defect_size_mm);
  }
  return known;
}

std::vector<double> carried(const Carrier& carrier, const signal::WindowSet& known, Label label,
                            std::size_t index) {
  Stream random("carried " + std::to_string(index));
  const std::vector<float> window = carrier.carry(journey_of(known, label, index), random).samples;
  return {window.begin(), window.end()};
}

class CarriedBy : public testing::TestWithParam<Response> {};
INSTANTIATE_TEST_SUITE_P(Transfer, CarriedBy,
                         testing::Values(Response::minimum_phase, Response::ring, Response::cut),
                         [](const auto& i) {
                           return i.param == Response::cut    ? "Cut"
                                  : i.param == Response::ring ? "Ring"
                                                              : "MinimumPhase";
                         });

TEST_P(CarriedBy, HasImpactsAtTheTestedRateAndTheKnownRms) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.response = GetParam();
  const Carrier carrier(known, edges, options);
  for (const Label label : {1, 3}) {
    const std::vector<double> window = carried(carrier, known, label, 2);
    ASSERT_EQ(window.size(), 1024U);
    const auto any = static_cast<std::size_t>(5 * (label - 1));
    const double period = period_s(known, any, 600) * 12000;
    const Comb tested = find_comb(window, period);
    const Comb known_rate = find_comb(window, period / 2 * 1.2);
    EXPECT_NEAR(tested.period, period, 0.01 * period);
    const auto height = [&](const Comb& comb) {
      double sum = 0;
      for (const std::size_t strike : comb.impact_positions(1024)) {
        const std::size_t end = std::min<std::size_t>(1024, strike + 10);
        for (std::size_t t = strike; t < end; ++t) sum += window[t] * window[t];
      }
      return sum / static_cast<double>(comb.impact_positions(1024).size());
    };
    EXPECT_GT(height(tested), 1.3 * height(known_rate)) << label;
    double square = 0;
    for (const double x : window) square += x * x;
    EXPECT_NEAR(square / 1024, 9, 1e-3);  // known windows have an RMS of 3
  }
}

/// Returns the log spectrum of 100 carried windows of OR8, without the structure of one_machine()
/// and the lines of the impact rate, which lie closer together than any quefrency of the edges.
Eigen::ArrayXd carried_edges(const signal::WindowSet& known,
                             const std::vector<impacts::Edges>& edges) {
  const Carrier carrier(known, edges, {});
  spectra::Windows windows(100, 1024);
  for (Eigen::Index i = 0; i < 100; ++i) {
    const std::vector<double> window = carried(carrier, known, 4, static_cast<std::size_t>(i));
    windows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(window.data(), 1024);
  }
  const double period = period_s(known, 19, 600) * 12000;
  return impacts::liftered(spectra::mean_power_spectrum(windows, 2).log() / 2, 0.8 * period) -
         three_resonances(1025, 12000);
}

/// Returns the root of the mean squared difference from log|E(f)|, apart from the level.
double distance(const Eigen::ArrayXd& seen, const impacts::Edges& edges) {
  Eigen::ArrayXd difference(440);
  for (Eigen::Index i = 0; i < 440; ++i) {
    const auto bin = static_cast<double>(60 + i);
    difference[i] = seen[60 + i] - std::log(edges.amplitude(bin * 12000 / 2048));
  }
  return std::sqrt((difference - difference.mean()).square().mean());
}

TEST(Carrier, MovesTheMinimaOfTheEdgesAndLeavesTheResonances) {
  const signal::WindowSet known = one_machine();
  const Eigen::ArrayXd seen = carried_edges(known, true_edges(known));
  const double to_tested = distance(seen, edges_at(known, 19, lag_shares[3], 600));
  EXPECT_LT(to_tested, 0.25);
  EXPECT_GT(distance(seen, edges_at(known, 19, lag_shares[3], 1200)), 2 * to_tested);
}

TEST(Carrier, LeavesTheSpectrumIfNoSizeIsKnown) {
  signal::WindowSet known = one_machine();
  for (signal::ClassInfo& c : known.info.classes) c.defect_size_mm = 0;
  const Eigen::ArrayXd seen = carried_edges(known, edges_of_known(known, {}));
  const signal::WindowSet with_size = one_machine();
  const double to_known = distance(seen, edges_at(with_size, 19, lag_shares[3], 1200));
  EXPECT_LT(to_known, 0.25);
  EXPECT_GT(distance(seen, edges_at(with_size, 19, lag_shares[3], 600)), 2 * to_known);
}

TEST_P(CarriedBy, StoresTheImpactTimes) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.response = GetParam();
  options.strengths.from = Strengths::alike;
  const Carrier carrier(known, edges, options);
  Stream random("told");
  const signal::MadeWindow carried = carrier.carry(journey_of(known, 3, 0), random);
  const std::vector<double> samples(carried.samples.begin(), carried.samples.end());
  const double period_s_given = period_s(known, 10, 600);
  ASSERT_GE(carried.impact_times_s->size(), 2U);
  for (std::size_t i = 1; i < carried.impact_times_s->size(); ++i) {
    EXPECT_NEAR(carried.impact_times_s->at(i) - carried.impact_times_s->at(i - 1), period_s_given,
                1e-4);
  }
  // The comb lies a few samples behind the impact.
  const Comb comb = find_comb(samples, period_s_given * 12000);
  const double behind = comb.first - carried.impact_times_s->front() * 12000;
  EXPECT_GE(behind, -0.15 * comb.period);
  EXPECT_LE(behind, 0.15 * comb.period);
}

// If nothing moves, a window combines two known windows; the parents record the second.
TEST(Carrier, RecordsTheKnownWindowInWhichOneEnds) {
  signal::WindowSet known = one_machine();
  known.info.conditions.clear();
  known.condition.clear();
  known.shaft_speed_rpm.clear();
  const std::vector<impacts::Edges> edges = true_edges(known);
  const Carrier carrier(known, edges, {});
  for (std::size_t i = 0; i < 20; ++i) {
    Stream random("ends " + std::to_string(i));
    Stream same("ends " + std::to_string(i));
    const Journey journey = journey_of(known, 2, i);
    ASSERT_EQ(journey.speed_ratio(), 1);
    // The five known windows of class 2, all of one bearing, start at index 5.
    EXPECT_EQ(carrier.carry(journey, random).parents,
              signal::parents_of({journey.known, 5 + same.below(5)}));
  }
}

TEST_P(CarriedBy, EndsInTheCarriedWindow) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.response = GetParam();
  const Carrier carrier(known, edges, options);
  Stream random("carried");
  const Journey journey = journey_of(known, 3, 4);
  EXPECT_EQ(carrier.carry(journey, random).parents, signal::parents_of({journey.known}));
}

TEST(Carrier, HasTheImpactStrengthsOfTheKnownWindow) {
  signal::WindowSet known = one_machine();
  const std::vector<double> every_second_is_weak{1, 0.15};
  for (std::size_t i = 0; i < 5; ++i) {
    const Eigen::ArrayXf window = impacts_like(known, i, every_second_is_weak, 3).cast<float>();
    std::ranges::copy(window, known.samples.begin() + static_cast<std::ptrdiff_t>(1024 * i));
  }
  const std::vector<impacts::Edges> edges = true_edges(known);
  // Returns the fraction of impacts whose successor is much stronger or much weaker.
  const auto uneven = [&](Strengths from) {
    CarryOptions options;
    options.strengths.from = from;
    const Carrier carrier(known, edges, options);
    double uneven = 0;
    double all = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      Stream random("strong " + std::to_string(i));
      const signal::MadeWindow carried = carrier.carry(journey_of(known, 1, i), random);
      std::vector<double> powers;
      for (const double impact_s : *carried.impact_times_s) {
        const auto begin = static_cast<std::size_t>(impact_s * 12000);
        if (begin + 20 > 1024) continue;
        double power = 0;
        for (std::size_t t = begin; t < begin + 20; ++t) power += std::pow(carried.samples[t], 2);
        powers.push_back(power);
      }
      for (std::size_t j = 1; j < powers.size(); ++j) {
        uneven += std::max(powers[j], powers[j - 1]) > 3 * std::min(powers[j], powers[j - 1]);
        ++all;
      }
    }
    return uneven / all;
  };
  EXPECT_GT(uneven(Strengths::known), 0.7);
  EXPECT_LT(uneven(Strengths::alike), 0.1);
}

TEST(Carrier, DoesNotUseStrengthsOfAnotherBearing) {
  const signal::WindowSet known = other_bearings_tested();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.strengths.from = Strengths::known;
  const Carrier as_known(known, edges, options);
  options.strengths.from = Strengths::load_zone;
  const Carrier in_load_zone(known, edges, options);
  EXPECT_EQ(carried(as_known, known, 1, 0), carried(in_load_zone, known, 1, 0));
}

/// IR8 is known at both speeds, in three windows and two, each with its own mean. At 1200 rpm only
/// those of 1200 rpm are joined, unchanged.
TEST(Carrier, JoinsKnownWindowsIfNothingChanges) {
  signal::WindowSet known = one_machine();
  known.info.conditions[1].known = true;
  known.info.conditions[1].shaft_speed_rpm = 600;
  known.info.conditions.push_back(
      {.name = "again", .shaft_speed_rpm = 1200, .known = false, .test = true, .healthy = true});
  known.info.conditions[1].test = false;
  for (std::size_t i = 5; i < 10; ++i) {
    for (std::size_t t = 0; t < 1024; ++t) {
      known.samples[1024 * i + t] += 1000 * static_cast<float>(i);
    }
    if (i < 8) continue;
    known.condition[i] = 1;
    known.shaft_speed_rpm[i] = 600;
  }
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.equaliser.spread_db = 20;  // would be visible at once
  const Carrier carrier(known, edges, options);
  std::size_t joined = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const Journey journey = journey_of(known, 2, i);
    if (journey.speed_ratio() != 1) continue;
    Stream random("joined " + std::to_string(i));
    std::set<long> sources;
    for (const float x : carrier.carry(journey, random).samples)
      sources.insert(std::lround(x / 1000));
    EXPECT_TRUE(sources.contains(static_cast<long>(journey.known)));
    EXPECT_LE(sources.size(), 2U);
    EXPECT_LT(*sources.rbegin(), 8);
    joined += sources.size() == 2;
  }
  EXPECT_GT(joined, 10U);  // 36 windows, of which 24 on average continue in another window
}

TEST(Carrier, NeedsHealthyWindowsOfTheTestedConditionForTheirBackground) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.background_from = BackgroundFrom::healthy;
  EXPECT_ERROR(Carrier(known, edges, options), Exit::usage, "give --healthy B.h5 of a data set");
  // The background is a single line at 3 kHz, and nothing else is there.
  Eigen::ArrayXd line = Eigen::ArrayXd::Constant(1025, -20);
  line[512] = 0;
  options.background = 1;
  const Carrier carrier(known, edges, options, {{.condition = 1, .log_amplitude = line}});
  options.background_from = BackgroundFrom::struck;
  const Carrier without(known, edges, options);
  const auto at_line = [&](const Carrier& from) {
    spectra::Windows windows(50, 1024);
    for (Eigen::Index i = 0; i < 50; ++i) {
      const std::vector<double> window = carried(from, known, 4, static_cast<std::size_t>(i));
      windows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(window.data(), 1024);
    }
    const Eigen::ArrayXd power = spectra::mean_power_spectrum(windows);
    return power[256] / power.sum();
  };
  // Half of the power on average; Hann's window leaves two thirds of it in the bin itself.
  EXPECT_GT(at_line(carrier), 0.2);
  EXPECT_LT(at_line(without), 0.05);
}

TEST(Carrier, FindsTheRingOfABearing) {
  const signal::WindowSet known = one_machine();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.mass_kg = 2;
  const Carrier carrier(known, edges, options);
  const auto ring_of = [&](std::size_t index) {
    Stream random("ring");
    return *carrier.carry(journey_of(known, 1, index), random).parameters;
  };
  const signal::DynamicParameters ring = ring_of(0);
  const double hz = std::sqrt(ring.stiffness_n_per_m / 2) / (2 * std::numbers::pi);
  double nearest = 1;  // distance to the nearest resonance of the structure
  for (const double resonance_hz : {1100.0, 2400.0, 4200.0}) {
    nearest = std::min(nearest, std::abs(hz / resonance_hz - 1));
  }
  EXPECT_LT(nearest, 0.1) << hz;
  EXPECT_EQ(ring_of(4).stiffness_n_per_m, ring.stiffness_n_per_m);
}

// A draw between equal bounds must terminate.
TEST(Carrier, UsesTheCommonKnownSizeForAnotherBearing) {
  const signal::WindowSet known = other_bearings_tested();
  const std::vector<impacts::Edges> edges = true_edges(known);
  CarryOptions options;
  options.size_factor = 1;
  const Carrier carrier(known, edges, options);
  EXPECT_EQ(carried(carrier, known, 1, 0).size(), 1024U);
}

TEST(Carrier, WorksOnWindowsOfAnyLength) {
  for (const std::size_t length : {64U, 101U, 1023U}) {
    signal::WindowSet known = one_machine();
    std::vector<float> shorter;
    for (std::size_t i = 0; i < known.size(); ++i) {
      const auto window = known.window(i);
      shorter.insert(shorter.end(), window.begin(), window.begin() + static_cast<long>(length));
    }
    known.samples = shorter;
    known.length = length;
    const std::vector<impacts::Edges> edges = edges_of_known(known, {});
    const Carrier carrier(known, edges, {});
    const std::vector<double> window = carried(carrier, known, 2, 0);
    ASSERT_EQ(window.size(), length);
    for (const double x : window) ASSERT_TRUE(std::isfinite(x)) << length;
  }
}

}  // namespace
}  // namespace piae::transfer
