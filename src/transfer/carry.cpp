#include "transfer/carry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "transfer/filter.hpp"
#include "transfer/kinematics.hpp"
#include "transfer/rhythm.hpp"
#include "transfer/strike_train.hpp"
#include "transfer/synthesis.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

std::vector<double> samples_of_window(const signal::WindowSet& windows, std::size_t i) {
  const auto window = windows.window(i);
  return {window.begin(), window.end()};
}

ArrayXd turned(std::vector<double> samples, Stream& random) {
  const auto first = static_cast<std::ptrdiff_t>(random.below(samples.size()));
  std::rotate(samples.begin(), samples.begin() + first, samples.end());
  return Eigen::Map<const ArrayXd>(samples.data(), static_cast<Index>(samples.size()));
}

}  // namespace

Carrier::Carrier(const signal::WindowSet& known, const std::vector<Edges>& edges,
                 const CarryOptions& options)
    : known_(known), edges_(edges), options_(options), structure_(structure_of(known, edges)) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::vector<double> samples = samples_of_window(known, i);
    combs_.push_back(
        find_comb(samples, period_s(known, i, known.speed_rpm(i)) * known.info.sample_rate_hz));
    strengths_.push_back(options.strengths == Strengths::known ? strengths(samples, combs_.back())
                                                               : std::vector<double>{1.0});
  }
}

double Carrier::draw_size_mm(std::size_t known, Stream& random) const {
  if (known_.defect_size_mm.empty()) return known_.size_mm(known);
  double least = std::numeric_limits<double>::max();
  double largest = 0;
  for (const std::size_t i : known_.indices_of(known_.labels[known])) {
    least = std::min(least, known_.size_mm(i));
    largest = std::max(largest, known_.size_mm(i));
  }
  const double factor = options_.size_factor;
  return std::exp(random.uniform(std::log(least / factor), std::log(largest * factor)));
}

Carrier::Draw Carrier::draw(const Journey& journey, Stream& random) const {
  const std::size_t known = journey.known;
  Draw draw{.edges = edges_[known],
            .period_s = period_s(
                known_, known, options_.rhythm == Set::tested ? journey.to_rpm : journey.from_rpm),
            .path = {}};
  if (options_.edges == Set::tested) {
    const double size_mm = draw_size_mm(known, random);
    draw.edges.lag_s *= passage_s(known_, known, size_mm, journey.to_rpm) /
                        passage_s(known_, known, known_.size_mm(known), journey.from_rpm) *
                        std::max(0.0, 1 + random.normal(0, options_.lag_deviation));
  }
  draw.path = draw_path(random, structure_.common.size(), known_.info.sample_rate_hz,
                        journey.speed_ratio(), options_);
  return draw;
}

ArrayXd Carrier::put_together(const Journey& journey, const Draw& draw, Stream& random) const {
  const double rate_hz = known_.info.sample_rate_hz;
  const double own = random.uniform(0, 1) * (1 - options_.own_structure) + options_.own_structure;
  const ArrayXd answer = structure_.common + own * structure_.own[journey.known];
  const double frame_s = 2 * static_cast<double>(answer.size() - 1) / rate_hz;
  const std::vector<Strike> strikes = draw_strikes(
      random, {.period_s = draw.period_s, .jitter = options_.jitter, .edges = draw.edges},
      strengths_[journey.known], frame_s);
  const double background = random.uniform(0, 1) * options_.background;
  return std::sqrt(1 - background) * struck_window(answer, draw.path, strikes, rate_hz) +
         std::sqrt(background) * background_window(answer, draw.path, draw.edges, rate_hz, random);
}

ArrayXd Carrier::cut_and_set(const Journey& journey, const Draw& draw, Stream& random) const {
  const Edges& known = edges_[journey.known];
  std::vector<std::complex<double>> gains(known_.length / 2 + 1);
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const double hz =
        static_cast<double>(i) * known_.info.sample_rate_hz / static_cast<double>(known_.length);
    const auto bin = static_cast<Index>(2 * i);  // of a frame of two windows
    gains[i] = draw.edges.gain(hz) / known.gain(hz) *
               std::polar(std::exp(draw.path.log_gain[bin]), draw.path.phase[bin]);
  }
  std::vector<double> samples = samples_of_window(known_, journey.known);
  filter(samples, gains);
  const std::vector<Cut> responses = cut_responses(samples, combs_[journey.known]);
  // A window in which no response is whole has no rhythm that could be changed.
  if (options_.rhythm == Set::known || responses.empty()) return turned(samples, random);
  samples = struck(responses, draw.period_s * known_.info.sample_rate_hz, options_.jitter,
                   known_.length, random);
  return Eigen::Map<const ArrayXd>(samples.data(), static_cast<Index>(samples.size()));
}

std::vector<float> Carrier::carry(const Journey& journey, Stream& random) const {
  const Draw drawn = draw(journey, random);
  const auto length = static_cast<Index>(known_.length);
  ArrayXd made = options_.response == Response::cut ? cut_and_set(journey, drawn, random)
                                                    : put_together(journey, drawn, random);
  const auto window = known_.window(journey.known);
  const ArrayXd known = Eigen::Map<const Eigen::ArrayXf>(window.data(), length).cast<double>();
  made.conservativeResize(length);
  made *= std::sqrt(known.square().mean() / made.square().mean());
  return {made.begin(), made.end()};
}

}  // namespace piae::transfer
