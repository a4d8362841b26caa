#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/standardise.hpp"
#include "diagnosis/wdcnn_options.hpp"

namespace piae::diagnosis {

/// What computes WDCNN on one training set: the network, its gradients and Adam. The course of the
/// training, in wdcnn.cpp, is the same with each.
class WdcnnBackend {
 public:
  virtual ~WdcnnBackend() = default;

  /// An epoch over the training windows in this order follows.
  virtual void begin_epoch(std::span<const std::size_t> order) = 0;
  /// One update of the parameters by the windows [begin, end) of that order, at least 2.
  virtual void step(std::int64_t begin, std::int64_t end) = 0;
  /// Sums over the windows since begin_epoch(), each at the parameters before its own update.
  virtual BatchOutcome finish_epoch() = 0;
  /// Softmax, row-major [n, classes], with the running statistics of batch normalisation.
  virtual std::vector<float> scores(const LabelledWindows& windows) = 0;
};

/// Makes one for a training set, which must outlive it; initial values come from `initial`.
using MakeWdcnnBackend = std::function<std::unique_ptr<WdcnnBackend>(
    const LabelledWindows& train, const WdcnnOptions& options, const Stream& initial)>;

}  // namespace piae::diagnosis
