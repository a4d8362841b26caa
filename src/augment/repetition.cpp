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
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const std::vector<std::size_t> own = known.indices_of(label);
    const std::size_t parent = own[index % own.size()];
    const auto window = known.window(parent);
    signal::MadeWindow made(std::vector<float>(window.begin(), window.end()));
    made.parents = signal::parents_of({parent});
    if (shift_ == Shift::circular) {
      const auto first = static_cast<std::ptrdiff_t>(random.below(made.samples.size()));
      std::rotate(made.samples.begin(), made.samples.begin() + first, made.samples.end());
    }
    return made;
  };
  return signal::make_windows(known.info, known.length, count, stream, make);
}

}  // namespace piae::augment
