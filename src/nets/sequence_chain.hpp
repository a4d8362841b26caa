#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Layers one after another, each of which is given what the one before it gives. Where two shapes
/// differ, they are of one size: a sequence is then read as one of other positions, such as a
/// window as frames.
template <class T>
class SequenceChain final : public SequenceLayer<T> {
 public:
  using Layers = std::vector<std::unique_ptr<SequenceLayer<T>>>;

  /// Throws std::logic_error where two neighbours do not fit, or where there is no layer.
  explicit SequenceChain(Layers layers);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  Layers layers_;
  std::vector<Eigen::ArrayX<T>> between_;  ///< what each layer but the last gave
  Eigen::ArrayX<T> gradients_[2];          ///< by turns
};

/// Layers that are made where they are listed: layers<T>(a, b, ...).
template <class T, class... Layer>
typename SequenceChain<T>::Layers layers(std::unique_ptr<Layer>... each) {
  typename SequenceChain<T>::Layers all;
  (all.push_back(std::move(each)), ...);
  return all;
}

extern template class SequenceChain<float>;
extern template class SequenceChain<double>;

}  // namespace piae::nets
