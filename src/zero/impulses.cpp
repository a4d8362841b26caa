#include "zero/impulses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "impacts/ranges.hpp"
#include "impacts/times.hpp"
#include "zero/background.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace ranges = impacts::ranges;

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// A resonance ends after this number of time constants, at 1/1000 of its amplitude.
constexpr double time_constants = 7;

/// Returns the rate at which the amplitude of impulses varies.
double modulation_hz(const Machine& machine, const Scene& scene) {
  const bearing::FaultFrequencies rates =
      bearing::fault_frequencies(machine.info().bearing, scene.shaft_speed_rpm);
  if (scene.defect == bearing::Defect::inner) return rates.shaft_hz;
  return scene.defect == bearing::Defect::roller ? rates.cage_hz : 0;
}

struct Decay {
  double rad_per_sample;
  double per_sample;  ///< 1 / time constant

  void add(double place, double strength, ArrayXd& window) const {
    const auto from = std::max<Index>(0, static_cast<Index>(std::ceil(place)));
    const auto to = std::min<Index>(
        window.size(), static_cast<Index>(std::ceil(place + time_constants / per_sample)));
    for (Index i = from; i < to; ++i) {
      const double after = static_cast<double>(i) - place;
      window[i] += strength * std::exp(-per_sample * after) * std::sin(rad_per_sample * after);
    }
  }
};

}  // namespace

cli::StoredOptions table_of(ImpulseOptions& o) {
  cli::StoredOptions table;
  table.in("/impulses");
  table.add("resonance-from", o.lowest_part, ranges::frequency_part,
            "lowest natural frequency / half the sample rate");
  table.add("resonance-to", o.highest_part, ranges::frequency_part,
            "highest natural frequency / half the sample rate");
  table.add("damping-ratio-from", o.least_damping, ranges::damping_ratio,
            "least damping ratio of a resonance");
  table.add("damping-ratio-to", o.largest_damping, ranges::damping_ratio,
            "largest damping ratio of a resonance");
  table.add("modulation", o.modulation, ranges::part,
            "largest modulation depth of the impulses by shaft (inner race) or cage (ball)");
  table.add("level-from-db", o.least_level_db, ranges::level_db,
            "least level of the impulses over the healthy window, dB");
  table.add("level-to-db", o.largest_level_db, ranges::level_db,
            "largest level of the impulses over the healthy window, dB");
  return table;
}

signal::MadeWindow add_impulses(const Machine& machine, const ImpulseOptions& options,
                                const Scene& scene, const Stream& random) {
  Stream draw = random.child("impulses");
  const double turn = 2 * std::numbers::pi;
  const double rad_per_sample =
      evenly(draw, options.lowest_part, options.highest_part) * std::numbers::pi;
  const double damping_ratio = log_evenly(draw, options.least_damping, options.largest_damping);
  const Decay decay{.rad_per_sample = rad_per_sample, .per_sample = damping_ratio * rad_per_sample};
  const double rate_hz = machine.info().sample_rate_hz;
  const double depth = draw.uniform(0, 1) * options.modulation;
  const double rad_per_s = turn * modulation_hz(machine, scene);
  const double phase = draw.uniform(0, turn);
  const double level_db = evenly(draw, options.least_level_db, options.largest_level_db);

  const double period = rate_hz / scene.impact_frequency_hz;
  const double first = draw.uniform(0, period);
  // Impulses before the window still ring in it.
  const double before = std::ceil(time_constants / decay.per_sample / period);
  const auto count = static_cast<std::size_t>(
      std::ceil((static_cast<double>(machine.length()) - first) / period) + before);
  ArrayXd with_impacts = ArrayXd::Zero(static_cast<Index>(machine.length()));
  std::vector<double> places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = first + (static_cast<double>(i) - before) * period;
    const double strength =
        rad_per_s > 0 ? 1 + depth * std::cos(phase + rad_per_s * place / rate_hz) : 1;
    decay.add(place, strength, with_impacts);
    places.push_back(place);
  }
  const double power = with_impacts.square().mean();
  if (power > 0) with_impacts *= std::pow(10, level_db / 20) / std::sqrt(power);
  signal::MadeWindow made =
      at_level_of(scene.healthy, with_impacts + draw_background(scene.healthy, 0, draw));
  made.impact_times_s = impacts::times_within(places, machine.length(), rate_hz);
  return made;
}

}  // namespace piae::zero
