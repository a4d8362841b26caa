#include "augment/stored_model.hpp"

#include <algorithm>
#include <cmath>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "phase/stored_inference.hpp"
#include "twin/curves.hpp"
#include "twin/outcome.hpp"

namespace piae::augment {

namespace {

const CatalogueEntry& entry_of(const artefact::Reader& model) {
  const CatalogueEntry* const entry = find_entry(model.text("/", "method"));
  if (entry == nullptr || entry->make == nullptr) {
    model.refuse("/, attribute method", "is not a method that makes a model");
  }
  return *entry;
}

/// Throws if the model's faults lack facts that its method needs; no training writes such a model.
void require_described(const artefact::Reader& model) {
  require_described_faults(entry_of(model), signal::read_dataset_info(model),
                           model.path().string());
}

/// Reads the parts of a model that generate() does not use, such as curves.
void require_record_of_training(const artefact::Reader& model) {
  model.require_finite();
  if (model.has("/curves/reconstruction")) twin::Curves().read(model);
  if (twin::has_outcome(model)) (void)twin::read_outcome(model);
  if (model.has("/inference")) (void)phase::read_inference(model);
}

/// Generates windows. If eq. 13 has no solution, the model's numbers are wrong, so the model is
/// refused.
signal::WindowSet generated_by(Method& method, const artefact::Reader& model, std::size_t count,
                               const Stream& stream, const Compute& compute) {
  try {
    return method.generate(model, count, stream, compute);
  } catch (const Error& error) {
    if (error.exit() != Exit::failed) throw;
    model.refuse("/", std::string("cannot make windows: ") + error.what());
  }
}

}  // namespace

std::unique_ptr<Method> method_of(const artefact::Reader& model) { return entry_of(model).make(); }

signal::WindowSet generate_with(Method& method, const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute) {
  require_described(model);
  require_record_of_training(model);
  signal::WindowSet windows = generated_by(method, model, count, stream, compute);
  if (!std::ranges::all_of(windows.samples, [](float x) { return std::isfinite(x); })) {
    model.refuse("/", "makes windows with NaN or infinite samples; train the model again");
  }
  return windows;
}

signal::WindowSet read_learned(const artefact::Reader& model, signal::Role role) {
  signal::WindowSet windows = signal::read_window_set(model);
  signal::require_belonging(model, role, windows);
  if (windows.size() == 0) {
    require_known_windows(entry_of(model), windows, model.path().string());
  }
  return windows;
}

void require_usable(const artefact::Reader& model) {
  const CatalogueEntry& entry = entry_of(model);
  (void)signal::read_origin(model);
  (void)generate_with(*entry.make(), model, 1, Stream("verify"), {});
}

}  // namespace piae::augment
