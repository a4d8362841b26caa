#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/standardise.hpp"
#include "diagnosis/wdcnn_options.hpp"
#include "diagnosis/wdcnn_weights.hpp"

namespace piae::diagnosis {

/// A WDCNN that can be asked.
class Wdcnn {
 public:
  virtual ~Wdcnn() = default;

  /// What the network makes of each window. Batch normalisation uses its running statistics.
  virtual Outputs outputs(const LabelledWindows& windows) = 0;
  [[nodiscard]] virtual WdcnnWeights weights() const = 0;
};

/// A back end: it computes WDCNN on one training set, with its gradients and the steps of Adam.
/// Which windows make a batch, and when the training ends, is decided in wdcnn.cpp, for every back
/// end alike.
class WdcnnBackend : public Wdcnn {
 public:
  /// Begins an epoch over the training windows in this order.
  virtual void begin_epoch(std::span<const std::size_t> order) = 0;
  /// One update of the parameters by the windows [begin, end) of that order, of which there must be
  /// at least 2.
  virtual void step(std::int64_t begin, std::int64_t end) = 0;
  /// What all batches since begin_epoch() gave together, each at the parameters before its update.
  virtual BatchOutcome finish_epoch() = 0;
};

/// Makes a back end, which owns its training set. Initial values come from `initial`.
using MakeWdcnnBackend = std::function<std::unique_ptr<WdcnnBackend>(
    LabelledWindows train, const WdcnnOptions& options, const Stream& initial)>;

}  // namespace piae::diagnosis
