#include "zero/twin.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "impacts/response.hpp"
#include "impacts/strengths.hpp"
#include "impacts/synthesis.hpp"
#include "zero/background.hpp"
#include "zero/ball.hpp"
#include "zero/draws.hpp"
#include "zero/impacts.hpp"
#include "zero/structure.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;
using Impacts = std::vector<impacts::Impact>;

/// Level of stray impacts over the background, dB.
constexpr double least_impacts_db = -15;
constexpr double largest_impacts_db = 5;

double amplitude_of(double db) { return std::pow(10, db / 20); }

/// Returns the times of the impacts in the last `length` samples of a frame, in s from the first of
/// those samples.
std::vector<double> times_in_window(const Impacts& impacts, Index frame, std::size_t length,
                                    double rate_hz) {
  std::vector<double> samples;
  samples.reserve(impacts.size());
  const double first = static_cast<double>(frame) - static_cast<double>(length);
  for (const impacts::Impact& impact : impacts) samples.push_back(impact.time_s * rate_hz - first);
  return impacts::times_within(samples, length, rate_hz);
}

/// Keeps the impacts inside a frame with a positive strength, and sorts them by time.
void keep_within(double frame_s, Impacts& impacts) {
  std::erase_if(impacts, [&](const impacts::Impact& impact) {
    return impact.strength <= 0 || impact.time_s < 0 || impact.time_s >= frame_s;
  });
  std::ranges::sort(impacts, {}, &impacts::Impact::time_s);
}

}  // namespace

Twin::Twin(const Machine& machine, const Prior& prior)
    : machine_(machine),
      prior_(prior),
      frame_s_(static_cast<double>(2 * (machine.length() + machine.length() % 2)) /
               machine.info().sample_rate_hz) {
  for (const Label label : machine.info().fault_labels()) {
    bearing::validate(machine.info().bearing,
                      {.fault_type = machine.info().class_of(label).defect,
                       .size_mm = largest_size_mm(machine.info().bearing, prior)});
  }
}

Impacts Twin::draw_impacts(const Scene& scene, const Stream& random) const {
  Stream when = random.child("rhythm");
  Stream strength = random.child("load");
  const double slip = evenly(when, -prior_.slip, prior_.slip);
  const impacts::ImpactRate rate = draw_rate(scene, slip, prior_, when);
  // bearing::speeds() takes the fraction of the speed that is lost.
  const bearing::Speeds speeds =
      bearing::speeds(machine_.info().bearing, scene.shaft_speed_rpm, -slip);
  const double cage_hz = speeds.cage / (2 * std::numbers::pi);
  const bool of_ball = scene.defect == bearing::Defect::roller;
  Impacts impacts = impacts::draw_impacts(when, rate, frame_s_);
  if (of_ball) {
    Stream races = random.child("races");
    Stream phase = random.child("phase");
    Stream moments = random.child("moments");
    alternate_races(prior_, races, impacts);
    turn_between_passes(rate.period, cage_hz, prior_, phase, impacts);
    scatter_in_time(frame_s_, prior_, moments, impacts);
  }
  const impacts::Load load = draw_load(scene.defect, speeds, prior_, strength);
  const double scatter = strength.uniform(0, 1) * prior_.load.scatter;
  impacts::apply_load(load, scatter, strength, impacts);
  if (of_ball) {
    Stream track = random.child("track");
    leave_track(rate.period, cage_hz, frame_s_, prior_, track, impacts);
  }
  keep_within(frame_s_, impacts);
  return impacts;
}

Twin::Synthesised Twin::synthesise(const Scene& scene, const ArrayXcd& response,
                                   const Stream& random) const {
  const double rate_hz = machine_.info().sample_rate_hz;
  Impacts impacts = draw_impacts(scene, random);
  Stream edges = random.child("edges");
  Stream floor = random.child("floor");
  const double lag_s = draw_lag_s(scene, machine_.info().bearing, prior_, edges);
  if (prior_.edges == Switch::on) add_second_edges(lag_s, prior_, edges, impacts);
  ArrayXd frame = impacts::impact_frame(impacts, response, rate_hz);
  if (bernoulli(floor, prior_.roughness)) {
    ArrayXd rough = draw_rough_floor(impacts, lag_s, frame.size(), rate_hz, floor);
    impacts::filter({rough.data(), static_cast<std::size_t>(rough.size())},
                    {response.data(), static_cast<std::size_t>(response.size())});
    frame += rough;
  }
  return {.window = impacts::window_of(frame, machine_.length()),
          .impact_times_s = times_in_window(impacts, frame.size(), machine_.length(), rate_hz)};
}

ArrayXd Twin::background(const Scene& scene, const ArrayXcd& response, const Stream& random) const {
  Stream under = random.child("background");
  Stream stray_random = random.child("knocks");
  ArrayXd healthy = draw_background(scene.healthy, prior_.background_db, under);
  const Impacts stray = draw_stray_impacts(frame_s_, prior_, stray_random);
  if (stray.empty()) return healthy;
  const double level = amplitude_of(evenly(stray_random, least_impacts_db, largest_impacts_db));
  const ArrayXd stray_frame = impacts::window_of(
      impacts::impact_frame(stray, response, machine_.info().sample_rate_hz), machine_.length());
  const ArrayXd both = healthy + level * stray_frame;
  return both / std::sqrt(both.square().mean());
}

signal::MadeWindow Twin::make(const Scene& scene, const Stream& random) const {
  const double rate_hz = machine_.info().sample_rate_hz;
  Stream structure = random.child("structure");
  Stream level_random = random.child("level");
  Stream modulating = random.child("modulation");
  const auto resonances = draw_resonances(prior_, rate_hz, structure);
  const ArrayXcd response = impacts::minimum_phase(draw_log_response(
      resonances, machine_.log_amplitude(scene.condition), rate_hz, prior_, structure));
  Synthesised synthesised = synthesise(scene, response, random);
  const double level =
      amplitude_of(evenly(level_random, prior_.least_level_db, prior_.largest_level_db));
  const ArrayXd window = (level * synthesised.window + background(scene, response, random)) *
                         draw_modulation(scene, machine_.info().bearing, machine_.length(), rate_hz,
                                         prior_, modulating);
  signal::MadeWindow made = at_level_of(scene.healthy, window);
  made.impact_times_s = std::move(synthesised.impact_times_s);
  made.parameters = impacts::ring_of(resonances, prior_.mass_kg);
  return made;
}

}  // namespace piae::zero
