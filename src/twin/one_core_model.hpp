#pragma once

#include <memory>

#include "twin/backend.hpp"

namespace piae::twin {

/// Opens a stored model with our own networks (networks.hpp). Throws artefact::Refusal if the model
/// is of another variant.
std::unique_ptr<StoredTwin> open_one_core_model(const artefact::Reader& model,
                                                const ModelDescription& description,
                                                const TwinVariant& variant);

}  // namespace piae::twin
