#include "zero/twin.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "transfer/cepstrum.hpp"
#include "transfer/filter.hpp"
#include "transfer/strike_train.hpp"
#include "zero/background.hpp"
#include "zero/ball.hpp"
#include "zero/draws.hpp"
#include "zero/impacts.hpp"
#include "zero/load.hpp"
#include "zero/nuisances.hpp"
#include "zero/rhythm.hpp"
#include "zero/structure.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;
using Strikes = std::vector<transfer::Strike>;

/// Of stray knocks over the background, dB.
constexpr double quietest_knocks_db = -15;
constexpr double loudest_knocks_db = 5;

double amplitude_of(double db) { return std::pow(10, db / 20); }

/// A frame of two windows that is struck so, by a structure of this response.
ArrayXd struck_frame(const Strikes& strikes, const ArrayXcd& response, double rate_hz) {
  const Index bins = response.size();
  return transfer::samples_of(
      response * transfer::excitation(strikes, bins, rate_hz / 2 / static_cast<double>(bins - 1)));
}

/// The last `length` samples, with the mean square 1, or nothing where nothing is.
ArrayXd window_of(const ArrayXd& frame, std::size_t length) {
  const ArrayXd window = frame.tail(static_cast<Index>(length));
  const double power = window.square().mean();
  return power > 0 ? ArrayXd(window / std::sqrt(power)) : window;
}

/// When strikes of a frame are in its last `length` samples, in s from the first of those.
std::vector<double> times_in_window(const Strikes& strikes, Index frame, std::size_t length,
                                    double rate_hz) {
  std::vector<double> samples;
  samples.reserve(strikes.size());
  const double begins = static_cast<double>(frame) - static_cast<double>(length);
  for (const transfer::Strike& strike : strikes)
    samples.push_back(strike.time_s * rate_hz - begins);
  return transfer::times_within(samples, length, rate_hz);
}

/// Those of a frame that are heard, in the order of their times.
void keep_heard(double frame_s, Strikes& strikes) {
  std::erase_if(strikes, [&](const transfer::Strike& strike) {
    return strike.strength <= 0 || strike.time_s < 0 || strike.time_s >= frame_s;
  });
  std::ranges::sort(strikes, {}, &transfer::Strike::time_s);
}

}  // namespace

Twin::Twin(const Machine& machine, const Prior& prior)
    : machine_(machine),
      prior_(prior),
      frame_s_(static_cast<double>(2 * (machine.length() + machine.length() % 2)) /
               machine.info().sample_rate_hz) {
  for (const Label label : machine.info().fault_labels()) {
    bearing::validate(machine.info().bearing,
                      {.kind = machine.info().class_of(label).defect,
                       .size_mm = largest_size_mm(machine.info().bearing, prior)});
  }
}

Strikes Twin::draw_strikes(const Scene& scene, const Stream& random) const {
  Stream when = random.child("rhythm");
  Stream strength = random.child("load");
  const Rhythm rhythm = draw_rhythm(scene, prior_, when);
  // Slip is of the cage, and counts what is lost.
  const bearing::Speeds speeds =
      bearing::speeds(machine_.info().bearing, scene.shaft_speed_rpm, -rhythm.slip);
  const double cage_hz = speeds.cage / (2 * std::numbers::pi);
  const bool of_ball = scene.defect == bearing::Defect::roller;
  Strikes strikes = regular_strikes(rhythm, frame_s_, when);
  if (of_ball) {
    Stream races = random.child("races");
    Stream phase = random.child("phase");
    Stream moments = random.child("moments");
    alternate_races(prior_, races, strikes);
    turn_between_passes(rhythm, cage_hz, prior_, phase, strikes);
    scatter_in_time(frame_s_, prior_, moments, strikes);
  }
  apply_load(draw_load(scene.defect, speeds, prior_, strength), prior_, strength, strikes);
  if (of_ball) {
    Stream track = random.child("track");
    leave_track(rhythm, cage_hz, frame_s_, prior_, track, strikes);
  }
  keep_heard(frame_s_, strikes);
  return strikes;
}

Twin::Struck Twin::strike(const Scene& scene, const ArrayXcd& response,
                          const Stream& random) const {
  const double rate_hz = machine_.info().sample_rate_hz;
  Strikes strikes = draw_strikes(scene, random);
  Stream edges = random.child("edges");
  Stream floor = random.child("floor");
  const double lag_s = draw_lag_s(scene, machine_.info().bearing, prior_, edges);
  if (prior_.edges == Switch::on) add_second_edges(lag_s, prior_, edges, strikes);
  ArrayXd frame = struck_frame(strikes, response, rate_hz);
  if (happens(floor, prior_.roughness)) {
    ArrayXd rough = draw_rough_floor(strikes, lag_s, frame.size(), rate_hz, floor);
    transfer::filter({rough.data(), static_cast<std::size_t>(rough.size())},
                     {response.data(), static_cast<std::size_t>(response.size())});
    frame += rough;
  }
  return {.window = window_of(frame, machine_.length()),
          .strikes_s = times_in_window(strikes, frame.size(), machine_.length(), rate_hz)};
}

ArrayXd Twin::background(const Scene& scene, const ArrayXcd& response, const Stream& random) const {
  Stream under = random.child("background");
  Stream knocking = random.child("knocks");
  ArrayXd healthy = draw_background(scene.healthy, prior_.background_db, under);
  const Strikes knocks = draw_stray_knocks(frame_s_, prior_, knocking);
  if (knocks.empty()) return healthy;
  const double level = amplitude_of(evenly(knocking, quietest_knocks_db, loudest_knocks_db));
  const ArrayXd heard =
      healthy + level * window_of(struck_frame(knocks, response, machine_.info().sample_rate_hz),
                                  machine_.length());
  return heard / std::sqrt(heard.square().mean());
}

Made Twin::make(const Scene& scene, const Stream& random) const {
  const double rate_hz = machine_.info().sample_rate_hz;
  Stream structure = random.child("structure");
  Stream loud = random.child("level");
  Stream modulating = random.child("modulation");
  const std::vector<Resonance> resonances = draw_resonances(prior_, rate_hz, structure);
  const ArrayXcd response = transfer::minimum_phase(draw_log_answer(
      resonances, machine_.log_amplitude(scene.condition), rate_hz, prior_, structure));
  Struck struck = strike(scene, response, random);
  const double level = amplitude_of(evenly(loud, prior_.least_level_db, prior_.largest_level_db));
  const ArrayXd window = (level * struck.window + background(scene, response, random)) *
                         draw_modulation(scene, machine_.info().bearing, machine_.length(), rate_hz,
                                         prior_, modulating);
  return {.samples = as_loud_as(scene.healthy, window),
          .strikes_s = std::move(struck.strikes_s),
          .ring = ring_of(resonances, prior_.mass_kg)};
}

}  // namespace piae::zero
