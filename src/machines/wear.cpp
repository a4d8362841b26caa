#include "machines/wear.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "bearing/kinematics.hpp"
#include "impacts/ranges.hpp"
#include "impacts/response.hpp"
#include "impacts/synthesis.hpp"
#include "zero/draws.hpp"
#include "zero/structure.hpp"

namespace piae::machines {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using signal::Defect;

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double most_slip = 0.012;
constexpr double most_of_outer = 0.3;  // largest depth at the shaft's speed, by a load that turns
constexpr double most_of_others = 0.9;

/// Rates of the modulation, in Hz, and its depths.
struct Modulation {
  double impacts_hz = 0;
  double impacts_depth = 0;
  double slow_hz = 0;
  double slow_depth = 0;
};

Modulation draw_wear_modulation(const Machine& machine, Defect defect, const Wear& wear,
                                Stream& random) {
  const double slip = zero::evenly(random, -most_slip, most_slip);
  const bearing::FaultFrequencies rates =
      bearing::fault_frequencies(machine.info.bearing, machine.info.shaft_speed_rpm, slip);
  const bool of_ball = defect == Defect::roller;
  Modulation modulation{.slow_hz = of_ball ? rates.cage_hz : rates.shaft_hz};
  modulation.impacts_hz = of_ball                   ? 2 * rates.bsf_hz
                          : defect == Defect::inner ? rates.bpfi_hz
                                                    : rates.bpfo_hz;
  modulation.impacts_depth =
      of_ball ? zero::evenly(random, 0, wear.ball_depth) : zero::evenly(random, wear.race_depth, 1);
  modulation.slow_depth =
      zero::evenly(random, 0, defect == Defect::outer ? most_of_outer : most_of_others);
  return modulation;
}

/// Returns between 0 and 1 for each sample: raised cosines, narrower for a higher power.
ArrayXd bumps(double hz, double phase, double power, const ArrayXd& time_s) {
  return (0.5 * (1 + (full_turn * hz * time_s + phase).cos())).pow(power);
}

ArrayXd draw_rolling_noise(const Machine& machine, const Modulation& modulation,
                           const zero::Prior& prior, Stream& random) {
  const double rate_hz = machine.info.sample_rate_hz;
  const auto frame = static_cast<Index>(2 * machine.length);
  const ArrayXd time_s = ArrayXd::LinSpaced(frame, 0, static_cast<double>(frame - 1)) / rate_hz;
  const double sharpness = 1 + static_cast<double>(random.below(6));
  const double first = zero::evenly(random, 0, full_turn);
  const double second = zero::evenly(random, 0, full_turn);
  const double fast = modulation.impacts_depth;
  const double slow = modulation.slow_depth;
  ArrayXd noise(frame);
  for (double& sample : noise) sample = random.normal(0, 1);
  noise *= (1 - fast + fast * bumps(modulation.impacts_hz, first, sharpness, time_s)) *
           (1 - slow + slow * bumps(modulation.slow_hz, second, 1, time_s));
  const auto resonances = zero::draw_resonances(prior, rate_hz, random);
  const Eigen::ArrayXcd response =
      zero::draw_log_response(resonances, machine.log_amplitude, rate_hz, prior, random)
          .exp()
          .cast<std::complex<double>>();
  impacts::filter({noise.data(), static_cast<std::size_t>(noise.size())},
                  {response.data(), static_cast<std::size_t>(response.size())});
  return impacts::window_of(noise, machine.length);
}

}  // namespace

cli::StoredOptions table_of(Wear& o) {
  namespace ranges = impacts::ranges;
  cli::StoredOptions table;
  table.in("/wear");
  table.add("wear-of-ball", o.on_ball, ranges::part,
            "probability that a defect of a ball makes noise of worn surfaces");
  table.add("wear-of-race", o.on_race, ranges::part, "the same for a defect of a race");
  table.add("wear-ball-depth", o.ball_depth, ranges::part,
            "largest modulation depth of this noise at 2 BSF");
  table.add("wear-race-depth", o.race_depth, ranges::part,
            "least modulation depth of this noise at BPFO or BPFI; the largest is 1");
  table.add("wear-from-db", o.least_level_db, ranges::level_db,
            "least level of this noise over the window without it, dB");
  table.add("wear-to-db", o.largest_level_db, ranges::level_db,
            "largest level of this noise over the window without it, dB");
  return table;
}

void add_wear(const Machine& machine, const Wear& wear, const zero::Prior& prior,
              const Stream& stream, signal::WindowSet& faults) {
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Stream random = stream.child(std::to_string(i));
    const Defect defect = faults.info.class_of(faults.labels[i]).defect;
    if (!zero::bernoulli(random, defect == Defect::roller ? wear.on_ball : wear.on_race)) continue;
    const Modulation modulation = draw_wear_modulation(machine, defect, wear, random);
    const ArrayXd noise = draw_rolling_noise(machine, modulation, prior, random);
    Eigen::Map<Eigen::ArrayXf> window(faults.samples.data() + i * faults.length,
                                      static_cast<Index>(faults.length));
    const double level =
        std::pow(10, zero::evenly(random, wear.least_level_db, wear.largest_level_db) / 20) *
        std::sqrt(window.cast<double>().square().mean());
    window += (level * noise).cast<float>();
  }
}

}  // namespace piae::machines
