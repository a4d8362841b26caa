#include "augment/playback.hpp"

#include <algorithm>
#include <cmath>

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "signal/resample.hpp"
#include "transfer/journey.hpp"

namespace piae::augment {

namespace {

/// Fade of the resampler at each end: a few hundred samples at the lower rate.
constexpr double fade_samples = 512;

}  // namespace

std::vector<double> played(std::span<const float> window, std::size_t start, double factor) {
  const std::size_t length = window.size();
  const auto lead = static_cast<std::size_t>(std::ceil(fade_samples / std::min(factor, 1.0)));
  const auto before = static_cast<std::size_t>(std::ceil(static_cast<double>(lead) * factor));
  std::vector<double> source(
      before + static_cast<std::size_t>(std::ceil(static_cast<double>(lead + length) * factor)) +
      1);
  const std::size_t first = start + length - before % length;
  for (std::size_t i = 0; i < source.size(); ++i) source[i] = window[(first + i) % length];
  const std::vector<double> all = signal::resample(source, factor, 1);
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(lead);
  return {begin, begin + static_cast<std::ptrdiff_t>(length)};
}

cli::StoredOptions Playback::table() {
  cli::StoredOptions table;
  impacts::add_to(table, equaliser_);
  return table;
}

void Playback::bind(const cli::Options& command) {
  if (speed_ == Speed::random) table().bind(command);
}

void Playback::train(const signal::WindowSet& known, const Stream& /*stream*/,
                     const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                     artefact::Writer& model) {
  signal::write(model, known);
  if (speed_ == Speed::random) table().write(model);
}

signal::WindowSet Playback::generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  const bool at_random = speed_ == Speed::random;
  if (at_random) table().read(model);
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const transfer::Journey journey = transfer::journey_of(known, label, index);
    const std::size_t start = random.below(known.length);
    const double factor = std::pow(journey.speed_ratio(), at_random ? random.uniform(0, 1) : 1.0);
    std::vector<double> samples = played(known.window(journey.known), start, factor);
    if (at_random) {
      const auto bins = static_cast<Eigen::Index>(known.length / 2 + 1);
      impacts::equalise(samples, impacts::draw_gains(random, bins, equaliser_));
    }
    return transfer::arrived(known, journey, samples);
  };
  return signal::make_windows(known.info, known.length, count, stream, make);
}

}  // namespace piae::augment
