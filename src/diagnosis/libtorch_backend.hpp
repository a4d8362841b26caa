#pragma once

#include <string>

#include "diagnosis/wdcnn_backend.hpp"

namespace piae::diagnosis {

/// WDCNN by LibTorch (wdcnn_network.hpp) on "cpu" or "cuda". Throws Error(usage) for another
/// device, and for "cuda" where there is none.
MakeWdcnnBackend libtorch_backend(const std::string& device);

}  // namespace piae::diagnosis
