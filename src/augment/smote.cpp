#include "augment/smote.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "augment/interpolation.hpp"
#include "augment/stored_model.hpp"
#include "base/error.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"

namespace piae::augment {

namespace {

/// Known windows of one class, and for each the indices of its nearest neighbours.
struct Neighbourhood {
  std::vector<std::size_t> indices;  ///< index of each window among all known windows
  std::vector<Window> windows;
  std::vector<std::vector<std::size_t>> neighbours;
};

void require_neighbours(const signal::ClassInfo& c, std::size_t n, int k) {
  if (static_cast<std::size_t>(k) < n) return;
  const std::string remedy =
      n > 1 ? fmt::format("give at most --neighbours {}", n - 1) : "SMOTE needs at least 2";
  throw Error(Exit::usage, fmt::format("--neighbours {}: class {} has {} known window{}; {}", k,
                                       c.name, n, n == 1 ? "" : "s", remedy));
}

/// Returns the neighbourhood of each class. The healthy class gets an empty one, because it is not
/// generated.
std::vector<Neighbourhood> neighbourhoods(const signal::WindowSet& known, int k) {
  std::vector<Neighbourhood> all;
  for (Label label = 0; index_of(label) < known.info.classes.size(); ++label) {
    const signal::ClassInfo& c = known.info.classes[index_of(label)];
    Neighbourhood& own = all.emplace_back();
    if (c.defect == signal::Defect::none) continue;
    own.indices = known.indices_of(label);
    for (const std::size_t i : own.indices) own.windows.push_back(known.window(i));
    require_neighbours(c, own.windows.size(), k);
    own.neighbours = nearest_neighbours(own.windows, static_cast<std::size_t>(k));
  }
  return all;
}

/// Returns the number of windows of the smallest fault class.
std::size_t fewest_windows(const signal::WindowSet& known) {
  std::size_t fewest = known.size();
  for (const Label label : known.info.fault_labels()) {
    fewest = std::min(fewest, known.count_of(label));
  }
  return fewest;
}

}  // namespace

void bind(const cli::Options& command, SmoteOptions& options) {
  command
      .add("--neighbours", options.neighbours,
           "k: interpolate a window with one of the k nearest of its class")
      .check(cli::positive_number());
}

void Smote::bind(const cli::Options& command) { augment::bind(command, options_); }

void Smote::train(const signal::WindowSet& known, const Stream& /*stream*/,
                  const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                  artefact::Writer& model) {
  neighbourhoods(known, options_.neighbours);  // throws early what generate() would throw
  signal::write(model, known);
  model.attribute("/", "neighbours", std::int64_t{options_.neighbours});
}

signal::WindowSet Smote::generate(const artefact::Reader& model, std::size_t count,
                                  const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  const Range neighbours{.low = 1, .high = static_cast<double>(fewest_windows(known)) - 1};
  const std::vector<Neighbourhood> all =
      neighbourhoods(known, static_cast<int>(model.integer("/", "neighbours", neighbours)));
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const Neighbourhood& own = all[index_of(label)];
    const std::size_t base = index % own.windows.size();
    const std::vector<std::size_t>& near = own.neighbours[base];
    const std::size_t neighbour = near[random.below(near.size())];
    signal::MadeWindow made =
        interpolate(own.windows[base], own.windows[neighbour], random.uniform(0, 1));
    made.parents = signal::parents_of({own.indices[base], own.indices[neighbour]});
    return made;
  };
  return signal::make_windows(known.info, known.length, count, stream, make);
}

}  // namespace piae::augment
