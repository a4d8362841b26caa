#pragma once

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/dataset_info.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// What a stored model says about itself besides its weights.
struct ModelDescription {
  signal::DatasetInfo info;
  NetworkShape shape;
  TwinOptions options;               ///< depth, width and keep are stored: they shape the networks
  std::vector<double> acceleration;  ///< a_ref per class, in the recordings' unit
};

void write(artefact::Writer& writer, const ModelDescription& description);
ModelDescription read_model_description(const artefact::Reader& reader);

}  // namespace piae::twin
