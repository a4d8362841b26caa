#include "zero/impulses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "transfer/strike_train.hpp"
#include "zero/background.hpp"
#include "zero/draws.hpp"
#include "zero/ranges.hpp"
#include "zero/settings.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

const std::string impulses_group = "/impulses";
/// A resonance is over after so many of its time constants: it has 1/1000 of its amplitude.
constexpr double time_constants = 7;

constexpr Setting<ImpulseOptions> impulse_settings[] = {
    {"resonance-from", &ImpulseOptions::lowest_part, ranges::frequency_part,
     "lowest resonance / half the sampling rate"},
    {"resonance-to", &ImpulseOptions::highest_part, ranges::frequency_part,
     "highest resonance / half the sampling rate"},
    {"damping-ratio-from", &ImpulseOptions::least_damping, ranges::damping_ratio,
     "least damping ratio of a resonance"},
    {"damping-ratio-to", &ImpulseOptions::largest_damping, ranges::damping_ratio,
     "largest damping ratio of a resonance"},
    {"modulation", &ImpulseOptions::modulation, ranges::part,
     "of the impulses by shaft (inner race) or cage (ball): largest depth"},
    {"level-from-db", &ImpulseOptions::least_level_db, ranges::level_db,
     "impulses over the healthy window: least, dB"},
    {"level-to-db", &ImpulseOptions::largest_level_db, ranges::level_db,
     "impulses over the healthy window: largest, dB"},
};

/// How fast the amplitude of impulses comes and goes.
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

void bind(const cli::Options& command, ImpulseOptions& options) {
  bind<ImpulseOptions>(command, options, impulse_settings);
}

void require_order(const ImpulseOptions& options) {
  require_order<ImpulseOptions>(options, impulse_settings);
}

void write(artefact::Writer& writer, const ImpulseOptions& options) {
  write<ImpulseOptions>(writer, impulses_group, options, impulse_settings);
}

ImpulseOptions read_impulse_options(const artefact::Reader& reader) {
  ImpulseOptions options;
  read<ImpulseOptions>(reader, impulses_group, options, impulse_settings);
  return options;
}

Made add_impulses(const Machine& machine, const ImpulseOptions& options, const Scene& scene,
                  const Stream& random) {
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

  const double period = rate_hz / scene.strike_hz;
  const double first = draw.uniform(0, period);
  // What was struck before the window still rings in it.
  const double before = std::ceil(time_constants / decay.per_sample / period);
  const auto count = static_cast<std::size_t>(
      std::ceil((static_cast<double>(machine.length()) - first) / period) + before);
  ArrayXd struck = ArrayXd::Zero(static_cast<Index>(machine.length()));
  std::vector<double> places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = first + (static_cast<double>(i) - before) * period;
    const double strength =
        rad_per_s > 0 ? 1 + depth * std::cos(phase + rad_per_s * place / rate_hz) : 1;
    decay.add(place, strength, struck);
    places.push_back(place);
  }
  const double power = struck.square().mean();
  if (power > 0) struck *= std::pow(10, level_db / 20) / std::sqrt(power);
  return {.samples = as_loud_as(scene.healthy, struck + draw_background(scene.healthy, 0, draw)),
          .strikes_s = transfer::times_within(places, machine.length(), rate_hz),
          .ring = {}};
}

}  // namespace piae::zero
