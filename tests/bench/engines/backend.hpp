#pragma once

#include <memory>
#include <stdexcept>

#include "diagnosis/batchwise_backend.hpp"

namespace piae::bench {

/// WDCNN on the primitives of a library: only training, in batches of one
/// size. Everything else, such as the order of the windows, is the same as for our own back end.
class EngineBackend : public diagnosis::BatchwiseBackend {
 public:
  using BatchwiseBackend::BatchwiseBackend;

  diagnosis::Outputs outputs(const diagnosis::LabelledWindows& /*windows*/) final {
    throw std::logic_error("a back end of the benchmark only trains");
  }
  [[nodiscard]] diagnosis::WdcnnWeights weights() const final {
    throw std::logic_error("a back end of the benchmark only trains");
  }
};

/// oneDNN's primitives for convolutions, batch normalisation with ReLU, pooling and dense layers,
/// in the layouts that it chooses.
std::unique_ptr<diagnosis::WdcnnBackend> make_onednn_backend(diagnosis::LabelledWindows train,
                                                             const diagnosis::WdcnnOptions& options,
                                                             const Stream& initial);

}  // namespace piae::bench
