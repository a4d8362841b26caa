#pragma once

#include "base/compute.hpp"
#include "diagnosis/wdcnn_backend.hpp"

namespace piae::libtorch {

/// WDCNN by LibTorch (network.hpp). Throws Error(usage) for cuda where there is no such device.
diagnosis::MakeWdcnnBackend wdcnn_on(Device device);

}  // namespace piae::libtorch
