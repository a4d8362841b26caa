#pragma once

#include <torch/types.h>

#include <memory>
#include <vector>

#include "twin/backend.hpp"

namespace piae::twin {

/// k~ and c~ of the points as float32 [n, 2], and back.
torch::Tensor as_tensor(const std::vector<TwinPoint>& points, torch::Device device);
std::vector<TwinPoint> as_points(const torch::Tensor& k_and_c);

/// Throws artefact::Refusal for a model of another variant.
std::unique_ptr<StoredTwin> open_with_libtorch(const artefact::Reader& model,
                                               const ModelDescription& description,
                                               const TwinVariant& variant, torch::Device device);

}  // namespace piae::twin
