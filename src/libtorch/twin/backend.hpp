#pragma once

#include "base/compute.hpp"
#include "twin/backend.hpp"

namespace piae::libtorch {

/// Every variant of the twin by LibTorch's eager operations.
twin::Engine twin_engine(Device device);

}  // namespace piae::libtorch
