#pragma once

#include <memory>

#include "diagnosis/adversary.hpp"
#include "diagnosis/wdcnn_backend.hpp"

namespace piae::diagnosis {

/// Makes our own back end, for one core in single precision (wdcnn_network.hpp).
std::unique_ptr<WdcnnBackend> make_one_core_backend(LabelledWindows train,
                                                    const WdcnnOptions& options,
                                                    const Stream& initial);

/// Returns a function that makes the same back end for a network that adapts.
MakeWdcnnBackend adapting_backend(Adversity settings);

}  // namespace piae::diagnosis
