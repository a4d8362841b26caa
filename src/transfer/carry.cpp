#include "transfer/carry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "bearing/strikes.hpp"
#include "transfer/cepstrum.hpp"
#include "transfer/excitation.hpp"
#include "transfer/filter.hpp"
#include "transfer/rhythm.hpp"

namespace piae::transfer {

namespace {

/// Below this part of half the sampling rate, the tilt of a spectrum ends.
constexpr double tilt_from = 0.05;
/// The frequency, as a part of half the sampling rate, that a tilt leaves as it is.
constexpr double tilt_about = 1.0 / 6;

double strike_period(const signal::DatasetInfo& info, Label label, double rpm) {
  return info.sample_rate_hz /
         bearing::strike_frequency_hz(info.bearing, info.class_of(label).defect, rpm);
}

double passage_s(const signal::DatasetInfo& info, Label label, double size_mm, double rpm) {
  return bearing::passage_s(info.bearing, {.kind = info.class_of(label).defect, .size_mm = size_mm},
                            rpm);
}

std::vector<double> turned(std::vector<double> samples, Stream& random) {
  const auto first = static_cast<std::ptrdiff_t>(random.below(samples.size()));
  std::ranges::rotate(samples, samples.begin() + first);
  return samples;
}

}  // namespace

Carrier::Carrier(const signal::WindowSet& known, const std::vector<Edges>& edges,
                 const CarryOptions& options)
    : known_(known), edges_(edges), options_(options), structure_(structure_of(known, edges)) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto window = known.window(i);
    const std::vector<double> samples(window.begin(), window.end());
    combs_.push_back(
        find_comb(samples, strike_period(known.info, known.labels[i], known.speed_rpm(i))));
    strengths_.push_back(strengths(samples, combs_.back()));
  }
}

double Carrier::draw_size_mm(Label label, Stream& random) const {
  double least = std::numeric_limits<double>::max();
  double largest = 0;
  for (const std::size_t i : known_.indices_of(label)) {
    least = std::min(least, known_.size_mm(i));
    largest = std::max(largest, known_.size_mm(i));
  }
  const double factor = options_.size_factor;
  return std::exp(random.uniform(std::log(least / factor), std::log(largest * factor)));
}

std::vector<double> Carrier::recoloured(const Journey& journey, double size_mm,
                                        Stream& random) const {
  const signal::DatasetInfo& info = known_.info;
  const Label label = known_.labels[journey.known];
  const Edges& known = edges_[journey.known];
  Edges tested = known;
  if (options_.edges == Set::tested) {
    tested.lag_s *= passage_s(info, label, size_mm, journey.to_rpm) /
                    passage_s(info, label, known_.size_mm(journey.known), journey.from_rpm) *
                    (1 + random.normal(0, options_.lag_deviation));
  }
  const double power = random.uniform(0, 1) * options_.tilt * std::log2(journey.speed_ratio());
  const std::size_t bins = known_.length / 2 + 1;
  const std::vector<double> path = draw_gains(random, bins, options_.equaliser);

  std::vector<std::complex<double>> gains(bins);
  for (std::size_t i = 0; i < bins; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(bins - 1);
    const double hz = part * info.sample_rate_hz / 2;
    gains[i] = tested.gain(hz) / known.gain(hz) * path[i] *
               std::pow(std::max(part, tilt_from) / tilt_about, power);
  }
  const auto window = known_.window(journey.known);
  std::vector<double> samples(window.begin(), window.end());
  filter(samples, gains);
  return samples;
}

std::vector<double> Carrier::synthesised(const Journey& journey, double size_mm,
                                         Stream& random) const {
  const signal::DatasetInfo& info = known_.info;
  const Label label = known_.labels[journey.known];
  const double rate_hz = info.sample_rate_hz;
  const auto bins = static_cast<Eigen::Index>(known_.length + 1);
  const double bin_hz = rate_hz / 2 / static_cast<double>(known_.length);
  Edges edges = edges_[journey.known];
  if (options_.edges == Set::tested) {
    edges.lag_s *= passage_s(info, label, size_mm, journey.to_rpm) /
                   passage_s(info, label, known_.size_mm(journey.known), journey.from_rpm) *
                   (1 + random.normal(0, options_.lag_deviation));
  }
  const double own = 1 - random.uniform(0, 1) * (1 - options_.least_own);
  Eigen::ArrayXd answer = structure_.common + own * structure_.own[journey.known];
  const double power = random.uniform(0, 1) * options_.tilt * std::log2(journey.speed_ratio());
  const std::vector<double> path =
      draw_gains(random, static_cast<std::size_t>(bins), options_.equaliser);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(bins - 1);
    answer[i] += std::log(path[static_cast<std::size_t>(i)]) +
                 power * std::log(std::max(part, tilt_from) / tilt_about);
  }
  const double period_s =
      strike_period(info, label,
                    options_.rhythm == Set::tested ? journey.to_rpm : journey.from_rpm) /
      rate_hz;
  const std::vector<double>& strong = strengths_[journey.known];
  std::size_t next = random.below(strong.size());
  const double frame_s = 2 * static_cast<double>(known_.length) / rate_hz;
  std::vector<Strike> strikes;
  double time_s = random.uniform(0, period_s);
  while (time_s < frame_s) {
    strikes.push_back({.time_s = time_s,
                       .strength = 1 + options_.strengths * (strong[next] - 1),
                       .lag_s = edges.lag_s * (1 + random.normal(0, edges.spread)),
                       .exit = edges.exit});
    next = (next + 1) % strong.size();
    time_s += period_s * std::max(0.5, 1 + random.normal(0, options_.jitter));
  }
  Eigen::ArrayXcd spectrum = minimum_phase(answer);
  // The group delay of the path: normal at the knots, straight between them.
  std::vector<double> delays_s(static_cast<std::size_t>(options_.equaliser.knots));
  for (double& s : delays_s) s = random.normal(0, options_.dispersion_s);
  double phase = 0;
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double place = static_cast<double>(i) / static_cast<double>(bins - 1) *
                         static_cast<double>(delays_s.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), delays_s.size() - 2);
    spectrum[i] *= std::polar(1.0, phase);
    phase -= 2 * std::numbers::pi * bin_hz *
             std::lerp(delays_s[below], delays_s[below + 1], place - static_cast<double>(below));
  }
  Eigen::ArrayXd hit = samples_of(spectrum * excitation(strikes, bins, bin_hz)).tail(bins - 1);
  Eigen::ArrayXcd noise(bins);
  for (Eigen::Index i = 0; i < bins; ++i) {
    noise[i] = std::abs(spectrum[i]) * std::abs(edges.gain(static_cast<double>(i) * bin_hz)) *
               std::complex<double>(random.normal(0, 1), random.normal(0, 1));
  }
  Eigen::ArrayXd rest = samples_of(noise).tail(bins - 1);
  const double share = random.uniform(0, 1) * options_.background;
  hit *= std::sqrt((1 - share) / hit.square().mean());
  rest *= std::sqrt(share / rest.square().mean());
  hit += rest;
  const auto window = known_.window(journey.known);
  double square = 0;
  for (const float x : window) square += static_cast<double>(x) * x;
  hit *= std::sqrt(square / static_cast<double>(window.size()));
  return {hit.begin(), hit.end()};
}

std::vector<double> Carrier::in_rhythm(const Journey& journey, const std::vector<double>& samples,
                                       Stream& random) const {
  const std::vector<Cut> responses = cut_responses(samples, combs_[journey.known]);
  // A window in which no response is whole has no rhythm that could be changed.
  if (responses.empty()) return turned(samples, random);
  const double period = strike_period(known_.info, known_.labels[journey.known], journey.to_rpm);
  return struck(responses, period, options_.jitter, known_.length, random);
}

std::vector<float> Carrier::carry(const Journey& journey, Stream& random) const {
  const Label label = known_.labels[journey.known];
  const double size_mm =
      known_.defect_size_mm.empty() ? known_.size_mm(journey.known) : draw_size_mm(label, random);
  if (options_.response == Response::minimum_phase) {
    const std::vector<double> made = synthesised(journey, size_mm, random);
    return {made.begin(), made.end()};
  }
  std::vector<double> samples = recoloured(journey, size_mm, random);
  samples = options_.rhythm == Set::tested ? in_rhythm(journey, samples, random)
                                           : turned(std::move(samples), random);
  return {samples.begin(), samples.end()};
}

}  // namespace piae::transfer
