#pragma once

#include "base/compute.hpp"
#include "twin/backend.hpp"

namespace piae::libtorch {

/// Computes every variant of the twin by LibTorch's eager operations. Throws Error(usage) for cuda
/// if LibTorch finds no such device.
twin::Engine twin_engine(Device device);

}  // namespace piae::libtorch
