#include "augment/strike_twin.hpp"

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "transfer/carry.hpp"
#include "transfer/known_bearings.hpp"
#include "transfer/known_edges.hpp"

namespace piae::augment {

namespace {

/// Reads the healthy spectra. Throws artefact::Refusal if the model needs them and has none.
std::vector<transfer::HealthySpectrum> read_background(const artefact::Reader& model,
                                                       const signal::WindowSet& known,
                                                       const transfer::CarryOptions& options) {
  std::vector<transfer::HealthySpectrum> spectra = transfer::read_healthy_spectra(model, known);
  if (options.background_from == transfer::BackgroundFrom::healthy &&
      spectra.size() != known.info.tested_conditions().size()) {
    model.refuse("/healthy", "lacks a tested condition, which the background needs");
  }
  return spectra;
}

}  // namespace

void StrikeTwin::bind(const cli::Options& command) { transfer::bind(command, options_); }

void StrikeTwin::use_healthy(const signal::WindowSet& healthy) {
  healthy_ = transfer::healthy_spectra(healthy);
}

void StrikeTwin::train(const signal::WindowSet& known, const Stream& /*stream*/,
                       const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                       artefact::Writer& model) {
  transfer::require_rate(known);
  transfer::require_sense(options_, known, healthy_);
  signal::write(model, known);
  transfer::write(model, transfer::edges_of_known(known, options_.prior));
  transfer::table_of(options_).write(model);
  transfer::write(model, healthy_);
}

signal::WindowSet StrikeTwin::generate(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  transfer::require_rate(known);
  const std::vector<impacts::Edges> edges = transfer::read_edges(model, known.size());
  transfer::CarryOptions options;
  transfer::table_of(options).read(model);
  const transfer::Carrier carrier(known, edges, options, read_background(model, known, options));
  return signal::make_windows(
      known.info, known.length, count, stream, [&](Label label, std::size_t index, Stream& random) {
        return carrier.carry(transfer::journey_of(known, label, index), random);
      });
}

}  // namespace piae::augment
