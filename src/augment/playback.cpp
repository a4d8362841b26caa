#include "augment/playback.hpp"

#include <cmath>
#include <utility>

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"
#include "transfer/journey.hpp"
#include "transfer/playback.hpp"

namespace piae::augment {

void Playback::bind(const cli::Options& command) {
  if (speed_ == Speed::random) transfer::bind(command, equaliser_);
}

void Playback::train(const signal::WindowSet& known, const Stream& /*stream*/,
                     const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                     artefact::Writer& model) {
  signal::write(model, known);
  if (speed_ == Speed::random) transfer::write(model, equaliser_);
}

signal::WindowSet Playback::generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  const bool at_random = speed_ == Speed::random;
  const auto equaliser =
      at_random ? transfer::read_equaliser_options(model) : transfer::EqualiserOptions{};
  std::vector<signal::Parents> parents;
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const transfer::Journey journey = transfer::journey_of(known, label, index);
    parents.push_back(signal::parents_of({journey.known}));
    const std::size_t start = random.below(known.length);
    const double factor = std::pow(journey.speed_ratio(), at_random ? random.uniform(0, 1) : 1.0);
    std::vector<double> samples = transfer::played(known.window(journey.known), start, factor);
    if (at_random) {
      transfer::equalise(samples, transfer::draw_gains(random, known.length / 2 + 1, equaliser));
    }
    return std::vector<float>(samples.begin(), samples.end());
  };
  signal::WindowSet made = signal::make_windows(known.info, known.length, count, stream, make);
  made.parents = std::move(parents);
  transfer::arrive(known, count, made);
  return made;
}

}  // namespace piae::augment
