#pragma once

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/dataset_info.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Description of a model, without its weights.
struct ModelDescription {
  signal::DatasetInfo info;
  NetworkShape shape;
  TwinOptions options;               ///< only depth, width, keep and positive are stored
  std::vector<double> acceleration;  ///< a_ref of each class, in the recordings' unit
};

void write(artefact::Writer& writer, const ModelDescription& description);
/// Throws artefact::Refusal if sizes or amplitudes are impossible, or if the word of keep is
/// unknown.
ModelDescription read_model_description(const artefact::Reader& reader);

}  // namespace piae::twin
