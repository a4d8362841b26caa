#include "transfer/carry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "bearing/strikes.hpp"
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
    : known_(known), edges_(edges), options_(options) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto window = known.window(i);
    const std::vector<double> samples(window.begin(), window.end());
    combs_.push_back(
        find_comb(samples, strike_period(known.info, known.labels[i], known.speed_rpm(i))));
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

std::vector<double> Carrier::in_rhythm(const Journey& journey, const std::vector<double>& samples,
                                       Stream& random) const {
  const std::vector<Response> responses = cut_responses(samples, combs_[journey.known]);
  // A window in which no response is whole has no rhythm that could be changed.
  if (responses.empty()) return turned(samples, random);
  const double period = strike_period(known_.info, known_.labels[journey.known], journey.to_rpm);
  return struck(responses, period, options_.jitter, known_.length, random);
}

std::vector<float> Carrier::carry(const Journey& journey, Stream& random) const {
  const Label label = known_.labels[journey.known];
  const double size_mm =
      known_.defect_size_mm.empty() ? known_.size_mm(journey.known) : draw_size_mm(label, random);
  std::vector<double> samples = recoloured(journey, size_mm, random);
  samples = options_.rhythm == Set::tested ? in_rhythm(journey, samples, random)
                                           : turned(std::move(samples), random);
  return {samples.begin(), samples.end()};
}

}  // namespace piae::transfer
