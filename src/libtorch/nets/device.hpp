#pragma once

#include <torch/types.h>

#include "base/compute.hpp"

namespace piae::libtorch {

/// Throws Error(usage) for cuda where LibTorch finds no such device. Also holds LibTorch to one
/// thread and to deterministic algorithms: parallelism comes from make and the scheduler, and
/// results must not depend on it.
torch::Device prepare_device(Device device);

}  // namespace piae::libtorch
