#include "transfer/carry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "transfer/bearings.hpp"
#include "transfer/filter.hpp"
#include "transfer/kinematics.hpp"
#include "transfer/rhythm.hpp"
#include "transfer/ring.hpp"
#include "transfer/synthesis.hpp"
#include "transfer/turning.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

std::vector<double> samples_of_window(const signal::WindowSet& windows, std::size_t i) {
  const auto window = windows.window(i);
  return {window.begin(), window.end()};
}

/// For each known window all those of its bearing.
std::vector<std::vector<std::size_t>> of_bearing(const signal::WindowSet& known) {
  std::vector<std::vector<std::size_t>> alike(known.size());
  for (const KnownBearing& bearing : bearings_of(known)) {
    for (const std::size_t i : bearing.windows) alike[i] = bearing.windows;
  }
  return alike;
}

/// The ring of each known window. Those of one bearing have the same one.
std::vector<signal::DynamicParameters> rings_of(const signal::WindowSet& known,
                                                const Structure& structure, double mass_kg) {
  std::vector<signal::DynamicParameters> rings(known.size());
  for (const KnownBearing& bearing : bearings_of(known)) {
    const signal::DynamicParameters ring =
        strongest_ring(structure.common + structure.own[bearing.windows.front()], mass_kg,
                       known.info.sample_rate_hz);
    for (const std::size_t i : bearing.windows) rings[i] = ring;
  }
  return rings;
}

}  // namespace

Carrier::Carrier(const signal::WindowSet& known, const std::vector<Edges>& edges,
                 const CarryOptions& options, std::vector<HealthySpectrum> healthy)
    : known_(known),
      edges_(edges),
      options_(options),
      structure_(structure_of(known, edges)),
      healthy_(std::move(healthy)),
      of_bearing_(of_bearing(known)),
      rings_(rings_of(known, structure_, options.mass_kg)) {
  require_sense(options_, known, healthy_);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::vector<double> samples = samples_of_window(known, i);
    combs_.push_back(
        find_comb(samples, period_s(known, i, known.speed_rpm(i)) * known.info.sample_rate_hz));
    if (strengths_from() == Strengths::known) {
      strengths_.push_back(seen_strengths(samples, combs_.back()));
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
    least = std::min(least, known_.size_mm(i));
    largest = std::max(largest, known_.size_mm(i));
  }
  const double factor = options_.size_factor;
  // Both may be the same, and a uniform draw needs two.
  return std::exp(
      std::lerp(std::log(least / factor), std::log(largest * factor), random.uniform(0, 1)));
}

Carrier::Draw Carrier::draw(const Journey& journey, Stream& random) const {
  const std::size_t known = journey.known;
  const double rpm = options_.rhythm == Set::tested ? journey.to_rpm : journey.from_rpm;
  Draw draw{.rhythm = {.period_s = period_s(known_, known, rpm),
                       .jitter = options_.jitter,
                       .edges = edges_[known]},
            .path = {}};
  if (options_.edges == Set::tested) {
    const double size_mm = draw_size_mm(known, random);
    draw.rhythm.edges.lag_s *= passage_s(known_, known, size_mm, journey.to_rpm) /
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

std::vector<double> Carrier::draw_strengths(const Journey& journey, const Rhythm& rhythm,
                                            double frame_s, Stream& random) const {
  const std::size_t count = most_strikes(rhythm, frame_s);
  switch (strengths_from()) {
    case Strengths::alike:
      return std::vector<double>(count, 1.0);
    case Strengths::known:
      return repeated_strengths(strengths_[journey.known], count, random);
    case Strengths::load_zone:
      break;
  }
  const Struck struck{.geometry = known_.info.bearing,
                      .kind = known_.info.class_of(known_.labels[journey.known]).defect,
                      .shaft_speed_rpm = journey.to_rpm,
                      .period_s = rhythm.period_s};
  return load_zone_strengths(struck, count, options_.strengths, random);
}

ArrayXd Carrier::answer(const Journey& journey, Stream& random) const {
  if (options_.response == Response::ring) {
    return ring_answer(rings_[journey.known], options_.mass_kg, structure_.common.size(),
                       known_.info.sample_rate_hz);
  }
  const double own = random.uniform(0, 1) * (1 - options_.own_structure) + options_.own_structure;
  return structure_.common + own * structure_.own[journey.known];
}

ArrayXd Carrier::background(const Journey& journey, const ArrayXd& answer, const Draw& draw,
                            Stream& random) const {
  const double rate_hz = known_.info.sample_rate_hz;
  if (options_.background_from == BackgroundFrom::struck) {
    return background_window(answer + draw.path.log_gain, draw.rhythm.edges, rate_hz, random);
  }
  return background_window(find_spectrum(healthy_, journey.condition)->log_amplitude, Edges{},
                           rate_hz, random);
}

Carried Carrier::put_together(const Journey& journey, Stream& random) const {
  const Draw drawn = draw(journey, random);
  const double rate_hz = known_.info.sample_rate_hz;
  const ArrayXd answers = answer(journey, random);
  const double half_s = static_cast<double>(answers.size() - 1) / rate_hz;
  const std::vector<Strike> strikes = draw_strikes(
      random, drawn.rhythm, draw_strengths(journey, drawn.rhythm, 2 * half_s, random), 2 * half_s);
  const ArrayXd struck = struck_window(answers, drawn.path, strikes, rate_hz);
  const double part = struck.isZero(0) ? 1 : random.uniform(0, 1) * options_.background;
  const ArrayXd made =
      std::sqrt(1 - part) * struck + std::sqrt(part) * background(journey, answers, drawn, random);
  StruckWindow window{.samples = {made.begin(), made.end()}, .strikes = {}};
  window.strikes.reserve(strikes.size());
  for (const Strike& strike : strikes) window.strikes.push_back((strike.time_s - half_s) * rate_hz);
  return as_loud_as_known(journey.known, std::move(window));
}

Carried Carrier::cut_and_set(const Journey& journey, Stream& random) const {
  const Draw drawn = draw(journey, random);
  const Edges& known = edges_[journey.known];
  std::vector<std::complex<double>> gains(known_.length / 2 + 1);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const double hz =
        static_cast<double>(i) * known_.info.sample_rate_hz / static_cast<double>(known_.length);
    const auto bin = static_cast<Index>(2 * i);  // of a frame of two windows
    gains[i] = drawn.rhythm.edges.gain(hz) / known.gain(hz) *
               std::polar(std::exp(drawn.path.log_gain[bin]), drawn.path.phase[bin]);
  }
  std::vector<double> samples = samples_of_window(known_, journey.known);
  filter(samples, gains);
  const std::vector<Cut> responses = cut_responses(samples, combs_[journey.known]);
  // A window in which no response is whole has no rhythm that could be changed.
  if (options_.rhythm == Set::known || responses.empty()) {
    const Turning turning = turning_of(samples, combs_[journey.known]);
    return as_loud_as_known(journey.known, turned(turning, turning, known_.length, random));
  }
  return as_loud_as_known(journey.known,
                          struck(responses, drawn.rhythm.period_s * known_.info.sample_rate_hz,
                                 options_.jitter, known_.length, random));
}

Carried Carrier::turn(std::size_t known, Stream& random) const {
  const std::vector<std::size_t>& alike = of_bearing_[known];
  const std::size_t other = alike[random.below(alike.size())];
  const StruckWindow window =
      turned(turning_of(samples_of_window(known_, known), combs_[known]),
             turning_of(samples_of_window(known_, other), combs_[other]), known_.length, random);
  return carried(window, other);
}

Carried Carrier::as_loud_as_known(std::size_t known, StruckWindow window) const {
  const auto length = static_cast<Index>(known_.length);
  window.samples.resize(known_.length);
  Eigen::Map<ArrayXd> made(window.samples.data(), length);
  const auto loud = known_.window(known);
  const ArrayXd before = Eigen::Map<const Eigen::ArrayXf>(loud.data(), length).cast<double>();
  made *= std::sqrt(before.square().mean() / made.square().mean());
  return carried(window, known);
}

Carried Carrier::carried(const StruckWindow& window, std::size_t goes_on_in) const {
  return {.samples = {window.samples.begin(), window.samples.end()},
          .strikes_s = times_within(window.strikes, known_.length, known_.info.sample_rate_hz),
          .goes_on_in = goes_on_in};
}

Carried Carrier::carry(const Journey& journey, Stream& random) const {
  if (!moves(journey)) return turn(journey.known, random);
  return options_.response == Response::cut ? cut_and_set(journey, random)
                                            : put_together(journey, random);
}

}  // namespace piae::transfer
