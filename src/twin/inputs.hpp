#pragma once

#include <torch/types.h>

#include <cstdint>
#include <vector>

#include "twin/space.hpp"

namespace piae::twin {

/// k~ and c~ of the points as float32 [n, 2].
torch::Tensor as_tensor(const std::vector<TwinPoint>& points, torch::Device device);

/// The label of one class for each of `count` windows, one-hot, float32 [count, classes].
torch::Tensor one_hot_of(std::size_t label, std::int64_t classes, std::size_t count,
                         torch::Device device);

}  // namespace piae::twin
