#include "augment/repetition.hpp"

#include <algorithm>
#include <utility>

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"

namespace piae::augment {

void Repetition::bind(const cli::Options& /*command*/) {}

void Repetition::train(const signal::WindowSet& known, const Stream& /*stream*/,
                       const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                       artefact::Writer& model) {
  signal::write(model, known);
}

signal::WindowSet Repetition::generate(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  std::vector<signal::Parents> parents;
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const std::vector<std::size_t> own = known.indices_of(label);
    const std::size_t parent = own[index % own.size()];
    const auto window = known.window(parent);
    parents.push_back(signal::parents_of({parent}));
    std::vector<float> samples(window.begin(), window.end());
    if (shift_ == Shift::circular) {
      const auto first = static_cast<std::ptrdiff_t>(random.below(samples.size()));
      std::rotate(samples.begin(), samples.begin() + first, samples.end());
    }
    return samples;
  };
  signal::WindowSet made = signal::make_windows(known.info, known.length, count, stream, make);
  made.parents = std::move(parents);
  return made;
}

}  // namespace piae::augment
