#include "machines/machine.hpp"

#include <algorithm>
#include <cmath>

#include "symptoms/measures.hpp"
#include "zero/draws.hpp"
#include "zero/prior.hpp"
#include "zero/structure.hpp"

namespace piae::machines {

namespace {

using signal::Defect;
using zero::bernoulli;
using zero::evenly;
using zero::log_evenly;

constexpr double pitch_mm = 40;  // lines depend on ratios of diameters only
constexpr std::size_t fewest_balls = 6;
constexpr int most_balls = 16;
/// Sum of the ball diameters / pitch diameter: the cage needs a tenth of the circumference.
constexpr double most_filled = 2.8;

bearing::Geometry draw_geometry(Stream& random) {
  const double ratio = evenly(random, 0.13, 0.32);
  const int most = std::min(most_balls, static_cast<int>(most_filled / ratio));
  const std::size_t choices = static_cast<std::size_t>(most) - fewest_balls + 1;
  return {.balls = static_cast<int>(fewest_balls + random.below(choices)),
          .ball_diameter_mm = ratio * pitch_mm,
          .pitch_diameter_mm = pitch_mm,
          .inner_raceway_mm = (1 - ratio) * pitch_mm,
          .outer_raceway_mm = (1 + ratio) * pitch_mm};
}

signal::DatasetInfo info_of(const bearing::Geometry& bearing, double rate_hz, double speed_rpm) {
  return {.name = "drawn machine",
          .sample_rate_hz = rate_hz,
          .shaft_speed_rpm = speed_rpm,
          .bearing = bearing,
          .classes = fault_type_classes(),
          .conditions = {}};
}

/// Draws bearing and speed until a window can separate the fault lines.
signal::DatasetInfo draw_info(std::size_t length, Stream& random) {
  for (;;) {
    const bearing::Geometry bearing = draw_geometry(random);
    const double rate_hz = log_evenly(random, 10e3, 26e3);
    const double turns = log_evenly(random, least_turns, 15);
    if (turns < symptoms::fewest_turns(bearing)) continue;
    return info_of(bearing, rate_hz, 60 * turns * rate_hz / static_cast<double>(length));
  }
}

Eigen::ArrayXd draw_log_amplitude(const Machine& machine, Stream& random) {
  const zero::Prior prior;
  const double rate_hz = machine.info.sample_rate_hz;
  const auto bins = static_cast<Eigen::Index>(machine.length + 1);
  const auto resonances = zero::draw_resonances(prior, rate_hz, random);
  const Eigen::ArrayXd response =
      zero::draw_log_response(resonances, Eigen::ArrayXd::Zero(bins), rate_hz, prior, random);
  return response - response.mean();
}

std::vector<Machine::Tone> draw_tones(const signal::DatasetInfo& info, Stream& random) {
  std::vector<Machine::Tone> tones;
  const std::size_t harmonics = random.below(12);
  for (std::size_t n = 1; n <= harmonics; ++n) {
    tones.push_back({.hz = static_cast<double>(n) * info.shaft_speed_rpm / 60,
                     .amplitude = std::exp(random.normal(0, 1)),
                     .of_shaft = true});
  }
  const std::size_t others = random.below(4);
  for (std::size_t n = 0; n < others; ++n) {
    tones.push_back({.hz = log_evenly(random, 50, 0.4 * info.sample_rate_hz),
                     .amplitude = std::exp(random.normal(0, 1))});
  }
  return tones;
}

}  // namespace

std::vector<signal::ClassInfo> fault_type_classes() {
  return {{.name = "healthy", .defect = Defect::none},
          {.name = "inner", .defect = Defect::inner},
          {.name = "ball", .defect = Defect::roller},
          {.name = "outer", .defect = Defect::outer}};
}

Machine draw_machine(const Stream& stream) {
  Stream random = stream.child("machine");
  Machine machine;
  machine.info = draw_info(machine.length, random);
  machine.log_amplitude = draw_log_amplitude(machine, random);
  machine.sensor_noise = std::pow(10, evenly(random, -30, -5) / 20);
  machine.tones = draw_tones(machine.info, random);
  machine.tone_power = std::pow(10, evenly(random, -20, 10) / 10);
  machine.window_db = log_evenly(random, 0.1, 1);
  machine.day_db = bernoulli(random, 0.5) ? log_evenly(random, 0.1, 3) : 0.01;
  for (double& depth : machine.modulation) {
    depth = bernoulli(random, 0.6) ? log_evenly(random, 0.005, 0.3) : 0;
  }
  machine.stray_impacts = bernoulli(random, 0.3) ? evenly(random, 0, 2) : 0;
  return machine;
}

}  // namespace piae::machines
