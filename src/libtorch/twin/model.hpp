#pragma once

#include <torch/types.h>

#include <memory>
#include <vector>

#include "twin/backend.hpp"

namespace piae::libtorch {

/// Converts the k~ and c~ of points to a float32 tensor [n, 2], and back.
torch::Tensor as_tensor(const std::vector<twin::TwinPoint>& points, torch::Device device);
std::vector<twin::TwinPoint> as_points(const torch::Tensor& k_and_c);

/// Opens the networks of a stored model. Throws artefact::Refusal if the model is of another
/// variant.
std::unique_ptr<twin::StoredTwin> open_model(const artefact::Reader& model,
                                             const twin::ModelDescription& description,
                                             const twin::TwinVariant& variant,
                                             torch::Device device);

}  // namespace piae::libtorch
