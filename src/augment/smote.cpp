#include "augment/smote.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "augment/healthy_model.hpp"
#include "augment/interpolation.hpp"
#include "augment/starting_windows.hpp"
#include "augment/stored_model.hpp"
#include "base/error.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"

namespace piae::augment {

namespace {

/// Permitted values of m.
constexpr Range among_range{.low = 1, .high = 1e6};

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

/// Returns the starting points of the windows of one class; none for the healthy class.
std::vector<std::size_t> starts_in(const Neighbourhood& own,
                                   const std::vector<std::int64_t>& weights, std::size_t count) {
  if (own.indices.empty()) return {};
  std::vector<std::int64_t> own_weights;
  for (const std::size_t i : own.indices) own_weights.push_back(weights[i]);
  return even_turns(own_weights, count);
}

/// Sets the weights of a class to 1 if all are 0, and returns true in this case.
bool made_equal(const std::vector<std::size_t>& own, std::vector<std::int64_t>& weights) {
  if (std::ranges::any_of(own, [&](std::size_t i) { return weights[i] > 0; })) return false;
  for (const std::size_t i : own) weights[i] = 1;
  return true;
}

}  // namespace

Smote::Smote(Start start) : start_(start) {
  options_.foreign_among = start == Start::in_danger ? 10 : 5;
}

void Smote::use_healthy(const signal::WindowSet& healthy) {
  if (start_ == Start::every) Method::use_healthy(healthy);  // throws
  healthy_ = healthy;
}

void Smote::bind(const cli::Options& command) {
  command
      .add("--neighbours", options_.neighbours,
           "k: interpolate a window with one of the k nearest of its class")
      .check(cli::positive_number());
  if (start_ == Start::every) return;
  command
      .add("--foreign-among", options_.foreign_among,
           "m: count the windows of other classes among the m nearest real ones")
      .check(cli::within(among_range));
}

Smote::Weights Smote::weights_from(const std::vector<std::int64_t>& foreign, int among,
                                   const signal::WindowSet& known) const {
  Weights weights{.of_windows = foreign};
  if (start_ == Start::in_danger) {
    for (std::int64_t& weight : weights.of_windows) {
      weight = 2 * weight >= among && weight < among ? 1 : 0;
    }
  }
  for (const Label label : known.info.fault_labels()) {
    if (made_equal(known.indices_of(label), weights.of_windows)) ++weights.classes_as_smote;
  }
  return weights;
}

std::vector<std::int64_t> Smote::read_weights(const artefact::Reader& model,
                                              const signal::WindowSet& known) const {
  if (start_ == Start::every) return std::vector<std::int64_t>(known.size(), 1);
  const std::int64_t among = model.integer("/", "foreign_among", among_range);
  const auto foreign = model.numbers<std::int64_t>("/foreign_neighbours", {known.size()}).values;
  model.require_all("/foreign_neighbours", foreign, {.low = 0, .high = static_cast<double>(among)});
  const Weights weights = weights_from(foreign, static_cast<int>(among), known);
  if (model.integer("/", "classes_as_smote") != weights.classes_as_smote) {
    model.refuse("/, attribute classes_as_smote",
                 fmt::format("must be {}, which follows from /foreign_neighbours",
                             weights.classes_as_smote));
  }
  return weights.of_windows;
}

void Smote::train(const signal::WindowSet& known, const Stream& /*stream*/,
                  const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                  artefact::Writer& model) {
  neighbourhoods(known, options_.neighbours);  // throws early what generate() would throw
  signal::write(model, known);
  model.attribute("/", "neighbours", std::int64_t{options_.neighbours});
  if (start_ == Start::every) return;
  const std::vector<std::int64_t> foreign =
      foreign_neighbours(known, require_healthy(healthy_, known), options_.foreign_among);
  const std::int64_t as_smote =
      weights_from(foreign, options_.foreign_among, known).classes_as_smote;
  model.attribute("/", "foreign_among", std::int64_t{options_.foreign_among});
  model.numbers("/foreign_neighbours", foreign);
  model.attribute("/", "classes_as_smote", as_smote);
  if (as_smote > 0) {
    remark_ =
        fmt::format(" ({} of them as smote: {})", as_smote,
                    start_ == Start::in_danger ? "no window in danger" : "no foreign neighbour");
  }
}

signal::WindowSet Smote::generate(const artefact::Reader& model, std::size_t count,
                                  const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  const Range neighbours{.low = 1, .high = static_cast<double>(fewest_windows(known)) - 1};
  const std::vector<Neighbourhood> all =
      neighbourhoods(known, static_cast<int>(model.integer("/", "neighbours", neighbours)));
  const std::vector<std::int64_t> weights = read_weights(model, known);
  std::vector<std::vector<std::size_t>> turns;
  turns.reserve(all.size());
  for (const Neighbourhood& own : all) turns.push_back(starts_in(own, weights, count));
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const Neighbourhood& own = all[index_of(label)];
    const std::size_t base = turns[index_of(label)][index];
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
