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

/// A WDCNN that computes outputs.
class Wdcnn {
 public:
  virtual ~Wdcnn() = default;

  /// Returns the output for each window. Batch normalisation uses its running statistics.
  virtual Outputs outputs(const LabelledWindows& windows) = 0;
  [[nodiscard]] virtual WdcnnWeights weights() const = 0;
};

/// A back end: computes WDCNN on one training set, with its gradients and the steps of Adam.
/// wdcnn.cpp decides the batches and the end of the training, equally for every back end.
class WdcnnBackend : public Wdcnn {
 public:
  /// Starts an epoch over the training windows in this order.
  virtual void begin_epoch(std::span<const std::size_t> order) = 0;
  /// Updates the parameters once by the windows [begin, end) of that order, at least 2.
  virtual void step(std::int64_t begin, std::int64_t end) = 0;
  /// Returns the sum over all batches since begin_epoch(), each at the parameters before its
  /// update.
  virtual BatchOutcome finish_epoch() = 0;
};

/// Makes a back end, which owns its training set. Initial values come from `initial`.
using MakeWdcnnBackend = std::function<std::unique_ptr<WdcnnBackend>(
    LabelledWindows train, const WdcnnOptions& options, const Stream& initial)>;

}  // namespace piae::diagnosis
