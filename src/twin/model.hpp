#pragma once

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/dataset_info.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// What a model says about itself besides its weights.
struct ModelDescription {
  signal::DatasetInfo info;
  NetworkShape shape;
  TwinOptions options;               ///< of these, only depth, width, keep and positive are stored
  std::vector<double> acceleration;  ///< a_ref of each class, in the recordings' unit
};

void write(artefact::Writer& writer, const ModelDescription& description);
/// Throws artefact::Refusal for sizes and amplitudes that cannot be, and for an unknown word of
/// keep.
ModelDescription read_model_description(const artefact::Reader& reader);

}  // namespace piae::twin
