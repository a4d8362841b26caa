#pragma once

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "twin/curves.hpp"
#include "twin/space.hpp"

namespace piae::twin {

/// A loss of eq. 23 at the end of a training, and its weight.
struct WeightedLoss {
  double loss = 0;    ///< mean over the batches of the last epoch
  double weight = 0;  ///< after the last epoch
  /// Returns the weight relative to the stationary point of eq. 23, 1 / (2 loss); 1 at that point.
  [[nodiscard]] double of_stationary() const { return 2 * weight * loss; }
  [[nodiscard]] double stationary() const { return 1 / (2 * loss); }
};

/// Outcome of training a twin with the physics-informed module.
struct Outcome {
  WeightedLoss differential;       ///< L_DDL and alpha
  WeightedLoss twin;               ///< L_DT and beta
  WeightedLoss reconstruction;     ///< L_Rec and gamma
  std::vector<TwinPoint> states;   ///< (k~, c~) of the known windows
  std::int64_t open_contacts = 0;  ///< known windows whose contact is open at rest
};

/// Adds to a model with curves and space the number of known windows with an open contact, and the
/// stationary points of the last epoch's weights.
void write_outcome(artefact::Writer& writer, const Curves& curves, std::int64_t open_contacts);

/// True if a model has an outcome. Older models and those without the physics-informed module do
/// not.
bool has_outcome(const artefact::Reader& model);

/// Throws artefact::Refusal if the model does not have an outcome.
Outcome read_outcome(const artefact::Reader& model);

}  // namespace piae::twin
