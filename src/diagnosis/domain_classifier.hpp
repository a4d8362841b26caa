#pragma once

#include <cstdint>
#include <memory>

#include "base/random.hpp"
#include "diagnosis/adaptation.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "nets/rows.hpp"

namespace piae::diagnosis {

/// Domain classifier of adversarial adaptation: judges from WDCNN's hidden units whether a window
/// has a label. It has one hidden layer with ReLU and a logistic output, and learns with Adam.
/// Programs use T = float; tests check it in double.
template <class T>
class DomainClassifier {
 public:
  static constexpr std::int64_t units = 100;  ///< of its hidden layer, as in Ganin et al. (2016)

  /// Makes a classifier for batches of at most `most_windows`; initial values come from the stream
  /// (nets/parameters.hpp).
  DomainClassifier(Adaptation adaptation, std::int64_t classes, std::int64_t most_windows,
                   const Stream& initial);

  /// Output of WDCNN for a batch: a row for each window, first those with a label.
  struct Batch {
    nets::Rows<const T> hidden;
    nets::Rows<const T> logits;
    std::int64_t windows;
    std::int64_t labelled;
  };

  /// Takes one step of Adam on the mean binary cross-entropy of a batch; returns the loss before
  /// it. Writes minus `reversal` times the gradient of the loss with respect to the hidden units to
  /// `gradient`. The class probabilities count as constants, as in Long et al.'s program.
  double step(const Batch& batch, double learning_rate, double reversal, nets::Rows<T> gradient);

  [[nodiscard]] nets::Parameters<T>& parameters() { return *parameters_; }

 private:
  /// Returns the class probabilities of a window; a single 1 without them.
  [[nodiscard]] std::vector<T> weights_of(const Batch& batch, std::int64_t window) const;

  std::int64_t classes_;  ///< 0 if it does not see the class probabilities
  std::shared_ptr<nets::Parameters<T>> parameters_;
  nets::DenseChain<T> chain_;
  std::int64_t steps_ = 0;
};

extern template class DomainClassifier<float>;
extern template class DomainClassifier<double>;

}  // namespace piae::diagnosis
