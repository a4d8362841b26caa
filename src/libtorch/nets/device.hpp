#pragma once

#include <torch/types.h>

#include "base/compute.hpp"

namespace piae::libtorch {

/// Returns LibTorch's name for a device. Also limits LibTorch to one thread and to deterministic
/// algorithms: make and the scheduler run programs in parallel, and results must not depend on
/// that. Throws Error(usage) for cuda if LibTorch finds no such device.
torch::Device prepare_device(Device device);

}  // namespace piae::libtorch
