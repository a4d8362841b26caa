#include "transfer/carry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "impacts/resonance.hpp"
#include "impacts/response.hpp"
#include "impacts/synthesis.hpp"
#include "transfer/endless_cycle.hpp"
#include "transfer/known_bearings.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

std::vector<double> samples_of_window(const signal::WindowSet& windows, std::size_t i) {
  const auto window = windows.window(i);
  return {window.begin(), window.end()};
}

}  // namespace

Carrier::Carrier(const signal::WindowSet& known, const std::vector<impacts::Edges>& edges,
                 const CarryOptions& options, std::vector<HealthySpectrum> healthy)
    : known_(known),
      edges_(edges),
      options_(options),
      structure_(structure_of(known, edges)),
      healthy_(std::move(healthy)),
      windows_(known.size()) {
  require_sense(options_, known, healthy_);
  const double rate_hz = known.info.sample_rate_hz;
  for (const KnownBearing& bearing : bearings_of(known)) {
    const std::size_t any = bearing.windows.front();
    const signal::DynamicParameters ring =
        impacts::strongest_ring(structure_.common + structure_.own[any], options.mass_kg, rate_hz);
    for (const std::size_t i : bearing.windows) {
      const std::vector<double> samples = samples_of_window(known, i);
      const Comb comb = find_comb(samples, period_s(known, i, known.speed_rpm(i)) * rate_hz);
      windows_[i] = {.alike = bearing.windows,
                     .ring = ring,
                     .comb = comb,
                     .strengths = seen_strengths(samples, comb)};
    }
  }
}

bool Carrier::moves(const Journey& journey) const {
  return journey.speed_ratio() != 1 || tests_other_bearings(known_);
}

double Carrier::draw_size_mm(std::size_t known, Stream& random) const {
  if (!tests_other_bearings(known_)) return known_.size_mm(known);
  double least = std::numeric_limits<double>::max();
  double largest = 0;
  for (const std::size_t i : known_.indices_of(known_.labels[known])) {
    if (known_.size_mm(i) == 0) continue;  // unknown
    least = std::min(least, known_.size_mm(i));
    largest = std::max(largest, known_.size_mm(i));
  }
  const double factor = options_.size_factor;
  // Both bounds may be equal, so lerp is used: a uniform draw needs two different ones.
  return std::exp(
      std::lerp(std::log(least / factor), std::log(largest * factor), random.uniform(0, 1)));
}

Carrier::Draw Carrier::draw(const Journey& journey, Stream& random) const {
  const std::size_t known = journey.known;
  const double rpm = options_.rate_of == Set::tested ? journey.to_rpm : journey.from_rpm;
  Draw draw{.rate = {.period = period_s(known_, known, rpm), .jitter = options_.jitter},
            .edges = edges_[known],
            .path = {}};
  if (options_.edges == Set::tested && known_.size_mm(known) > 0) {
    const double size_mm = draw_size_mm(known, random);
    draw.edges.lag_s *= passage_s(known_, known, size_mm, journey.to_rpm) /
                        passage_s(known_, known, known_.size_mm(known), journey.from_rpm) *
                        std::max(0.0, 1 + random.normal(0, options_.lag_deviation));
  }
  draw.path = draw_path(random, structure_.common.size(), known_.info.sample_rate_hz,
                        journey.speed_ratio(), tests_other_bearings(known_), options_);
  return draw;
}

Strengths Carrier::strengths_from() const {
  const bool of_another = tests_other_bearings(known_);
  return of_another && options_.strengths.from == Strengths::known ? Strengths::load_zone
                                                                   : options_.strengths.from;
}

std::vector<double> Carrier::draw_strengths(const Journey& journey, double period_s,
                                            std::size_t count, Stream& random) const {
  switch (strengths_from()) {
    case Strengths::alike:
      return std::vector<double>(count, 1.0);
    case Strengths::known:
      return repeated_strengths(windows_[journey.known].strengths, count, random);
    case Strengths::load_zone:
      break;
  }
  return load_zone_strengths(known_.info.class_of(known_.labels[journey.known]).defect,
                             bearing::speeds(known_.info.bearing, journey.to_rpm), period_s, count,
                             options_.strengths.load, random);
}

ArrayXd Carrier::response(const Journey& journey, Stream& random) const {
  if (options_.response == Response::ring) {
    return impacts::ring_response(windows_[journey.known].ring, options_.mass_kg,
                                  structure_.common.size(), known_.info.sample_rate_hz);
  }
  const double own = random.uniform(0, 1) * (1 - options_.own_structure) + options_.own_structure;
  return structure_.common + own * structure_.own[journey.known];
}

ArrayXd Carrier::background(const Journey& journey, const ArrayXd& response, const Draw& draw,
                            Stream& random) const {
  const double rate_hz = known_.info.sample_rate_hz;
  if (options_.background_from == BackgroundFrom::struck) {
    return impacts::noise_window(response + draw.path.log_gain, draw.edges, rate_hz, random);
  }
  return impacts::noise_window(find_spectrum(healthy_, journey.condition)->log_amplitude, {},
                               rate_hz, random);
}

ImpactWindow Carrier::put_together(const Journey& journey, Stream& random) const {
  const Draw drawn = draw(journey, random);
  const double rate_hz = known_.info.sample_rate_hz;
  const ArrayXd log_response = response(journey, random);
  const auto half = static_cast<std::size_t>(log_response.size() - 1);
  const double half_s = static_cast<double>(half) / rate_hz;
  const std::vector<double> strengths = draw_strengths(
      journey, drawn.rate.period, impacts::most_impacts(drawn.rate, 2 * half_s), random);
  const std::vector<impacts::Impact> impacts =
      impacts::draw_impacts(random, drawn.rate, 2 * half_s, [&](std::size_t i) {
        return impacts::Impact{
            .strength = strengths[i],
            .lag_s = drawn.edges.lag_s * (1 + random.normal(0, drawn.edges.spread)),
            .exit = drawn.edges.exit};
      });
  const ArrayXd with_impacts = impacts::window_of(
      impacts::impact_frame(impacts, response_behind(drawn.path, log_response), rate_hz), half);
  const double part = with_impacts.isZero(0) ? 1 : random.uniform(0, 1) * options_.background;
  const ArrayXd made = std::sqrt(1 - part) * with_impacts +
                       std::sqrt(part) * background(journey, log_response, drawn, random);
  ImpactWindow window{.samples = {made.begin(), made.end()}, .impact_positions = {}};
  window.impact_positions.reserve(impacts.size());
  for (const impacts::Impact& impact : impacts) {
    window.impact_positions.push_back((impact.time_s - half_s) * rate_hz);
  }
  return window;
}

ImpactWindow Carrier::cut_and_set(const Journey& journey, Stream& random) const {
  const Draw drawn = draw(journey, random);
  const double rate_hz = known_.info.sample_rate_hz;
  std::vector<std::complex<double>> gains(known_.length / 2 + 1);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const double hz = static_cast<double>(i) * rate_hz / static_cast<double>(known_.length);
    const auto bin = static_cast<Index>(2 * i);  // bin of a frame of two windows
    gains[i] = drawn.edges.gain(hz) / edges_[journey.known].gain(hz) *
               std::polar(std::exp(drawn.path.log_gain[bin]), drawn.path.phase[bin]);
  }
  std::vector<double> samples = samples_of_window(known_, journey.known);
  impacts::filter(samples, gains);
  const std::vector<Cut> responses = cut_responses(samples, windows_[journey.known].comb);
  // A window without a whole response has no rate that could be changed.
  if (options_.rate_of == Set::known || responses.empty()) {
    const EndlessCycle endless = endless_cycle_of(samples, windows_[journey.known].comb);
    return window_of_cycles(endless, endless, known_.length, random);
  }
  return with_impacts(responses,
                      {.period = drawn.rate.period * rate_hz, .jitter = drawn.rate.jitter},
                      known_.length, random);
}

void Carrier::match_level(std::size_t known, std::vector<double>& samples) const {
  const auto length = static_cast<Index>(known_.length);
  samples.resize(known_.length);
  Eigen::Map<ArrayXd> made(samples.data(), length);
  const ArrayXd before =
      Eigen::Map<const Eigen::ArrayXf>(known_.window(known).data(), length).cast<double>();
  made *= std::sqrt(before.square().mean() / made.square().mean());
}

signal::MadeWindow Carrier::carry(const Journey& journey, Stream& random) const {
  ImpactWindow window;
  std::size_t last = journey.known;
  if (!moves(journey)) {
    const std::vector<std::size_t>& alike = windows_[journey.known].alike;
    last = alike[random.below(alike.size())];
    const auto endless = [&](std::size_t i) {
      return endless_cycle_of(samples_of_window(known_, i), windows_[i].comb);
    };
    window = window_of_cycles(endless(journey.known), endless(last), known_.length, random);
  } else {
    window = options_.response == Response::cut ? cut_and_set(journey, random)
                                                : put_together(journey, random);
    match_level(journey.known, window.samples);
  }
  signal::MadeWindow made = arrived(known_, journey, window.samples);
  made.impact_times_s =
      impacts::times_within(window.impact_positions, known_.length, known_.info.sample_rate_hz);
  made.parameters = windows_[journey.known].ring;
  made.parents = signal::parents_of({journey.known, last});
  return made;
}

}  // namespace piae::transfer
