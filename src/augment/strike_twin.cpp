#include "augment/strike_twin.hpp"

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"
#include "transfer/carry.hpp"
#include "transfer/journey.hpp"
#include "transfer/kinematics.hpp"
#include "transfer/known_edges.hpp"
#include "transfer/stored_edges.hpp"

namespace piae::augment {

namespace {

/// Throws artefact::Refusal for a model that needs healthy windows and has none.
std::vector<transfer::HealthySpectrum> read_background(const artefact::Reader& model,
                                                       const signal::WindowSet& known,
                                                       const transfer::CarryOptions& options) {
  std::vector<transfer::HealthySpectrum> spectra = transfer::read_healthy_spectra(model, known);
  if (options.background_from == transfer::BackgroundFrom::healthy &&
      spectra.size() != known.info.tested_conditions().size()) {
    model.refuse("/healthy", "lacks a tested condition, of which the background is to be");
  }
  return spectra;
}

}  // namespace

void StrikeTwin::bind(const cli::Options& command) { transfer::bind(command, options_); }

void StrikeTwin::hear(const signal::WindowSet& healthy) {
  healthy_ = transfer::healthy_spectra(healthy);
}

void StrikeTwin::train(const signal::WindowSet& known, const Stream& /*stream*/,
                       const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                       artefact::Writer& model) {
  transfer::require_rhythm(known);
  transfer::require_sense(options_, known, healthy_);
  signal::write(model, known);
  transfer::write(model, transfer::edges_of_known(known, options_.prior));
  transfer::write(model, options_);
  transfer::write(model, healthy_);
}

signal::WindowSet StrikeTwin::generate(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  transfer::require_rhythm(known);
  const std::vector<transfer::Edges> edges = transfer::read_edges(model, known.size());
  const transfer::CarryOptions options = transfer::read_carry_options(model);
  const transfer::Carrier carrier(known, edges, options, read_background(model, known, options));
  std::vector<std::vector<double>> strikes_s;
  std::vector<signal::DynamicParameters> rings;
  std::vector<signal::Parents> parents;
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const transfer::Journey journey = transfer::journey_of(known, label, index);
    transfer::Carried carried = carrier.carry(journey, random);
    strikes_s.push_back(std::move(carried.strikes_s));
    parents.push_back(signal::parents_of({journey.known, carried.goes_on_in}));
    rings.push_back(carrier.ring(journey.known));
    return std::move(carried.samples);
  };
  signal::WindowSet made = signal::make_windows(known.info, known.length, count, stream, make);
  made.strikes_s = std::move(strikes_s);
  made.parameters = std::move(rings);
  made.parents = std::move(parents);
  transfer::arrive(known, count, made);
  return made;
}

}  // namespace piae::augment
