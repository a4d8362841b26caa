#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/adaptation.hpp"
#include "diagnosis/domain_classifier.hpp"
#include "diagnosis/wdcnn_network.hpp"

namespace piae::diagnosis {

/// Settings of an adaptation.
struct Adversity {
  Adaptation adaptation;
  std::vector<float>
      unlabelled;  ///< row-major [n, length], inputs of windows without labels, at least one
  /// Their order in pass k, counted from 1, comes from the child "unlabelled<k>".
  Stream stream;
};

/// Returns the weight of the reversed gradient, which rises from 0 to almost 1 as `progress` goes
/// from 0 to 1 (Ganin et al. 2016, Section 5.2.2). The loss that it multiplies is the mean over the
/// labelled and unlabelled windows together, as in the program of Long et al. (2018), so it counts
/// half as much as Ganin et al.'s sum of two means.
double reversal_at(double progress);

/// The opponent of a WDCNN in training: draws as many unlabelled windows as a batch has labelled
/// ones, and turns the gradient of its domain classifier against the network.
class Adversary {
 public:
  /// The network will make `steps` steps with batches of at most `most_labelled` labelled windows.
  Adversary(Adversity settings, std::size_t length, std::int64_t classes,
            std::int64_t most_labelled, std::int64_t steps, double learning_rate,
            const Stream& initial);

  /// Returns the labelled windows followed by as many unlabelled ones. The whole is one batch for
  /// batch normalisation, so that training and test use the same statistics.
  std::span<const float* const> joined(std::span<const float* const> labelled);

  /// Trains the domain classifier on what the network made of joined(). Returns the reversed
  /// gradient for WdcnnNetwork::backward().
  std::span<const float> gradient(WdcnnNetwork<float>& network);

 private:
  const float* next();

  std::vector<float> unlabelled_;
  Stream stream_;
  std::size_t length_;
  std::int64_t steps_;
  double learning_rate_;
  DomainClassifier<float> domains_;
  std::int64_t done_ = 0;           ///< steps
  std::int64_t pass_ = 0;           ///< over the unlabelled windows
  std::vector<std::size_t> order_;  ///< what is left of this pass, the next window last
  std::vector<const float*> windows_;
  std::vector<float> gradient_;
};

}  // namespace piae::diagnosis
