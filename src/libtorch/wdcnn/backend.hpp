#pragma once

#include "base/compute.hpp"
#include "diagnosis/wdcnn_backend.hpp"

namespace piae::libtorch {

/// Makes back ends that compute WDCNN by LibTorch (network.hpp) on a device. Throws Error(usage)
/// for cuda if LibTorch finds no such device.
diagnosis::MakeWdcnnBackend wdcnn_on(Device device);

}  // namespace piae::libtorch
