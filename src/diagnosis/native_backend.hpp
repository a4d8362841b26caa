#pragma once

#include <memory>

#include "diagnosis/wdcnn_backend.hpp"

namespace piae::diagnosis {

/// WDCNN on one core without LibTorch, in single precision (native_network.hpp).
std::unique_ptr<WdcnnBackend> make_native_backend(const LabelledWindows& train,
                                                  const WdcnnOptions& options,
                                                  const Stream& initial);

}  // namespace piae::diagnosis
