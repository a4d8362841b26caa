#pragma once

#include <cstdint>
#include <memory>

#include "diagnosis/wdcnn_backend.hpp"
#include "diagnosis/wdcnn_network.hpp"

namespace piae::diagnosis {

/// Returns the output of our one-core network for windows, `batch` of them at a time.
Outputs outputs_of(WdcnnNetwork<float>& network, std::int64_t batch,
                   const LabelledWindows& windows);

/// Makes a trained network on one core, without the memory that only a training needs.
std::unique_ptr<Wdcnn> wdcnn_of(const WdcnnWeights& weights);

}  // namespace piae::diagnosis
