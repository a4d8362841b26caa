#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// A chain of layers: each layer's input is the previous layer's output. Neighbouring shapes may
/// differ if their sizes are equal: the sequence is then reinterpreted with other positions, such
/// as a window as frames.
template <class T>
class SequenceChain final : public SequenceLayer<T> {
 public:
  using Layers = std::vector<std::unique_ptr<SequenceLayer<T>>>;

  /// Throws std::logic_error if two neighbours do not fit or `layers` is empty.
  explicit SequenceChain(Layers layers);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  Layers layers_;
  std::vector<Eigen::ArrayX<T>> between_;  ///< output of each layer except the last
  Eigen::ArrayX<T> gradients_[2];          ///< used alternately
};

/// Makes a list of layers: layers<T>(a, b, ...).
template <class T, class... Layer>
typename SequenceChain<T>::Layers layers(std::unique_ptr<Layer>... each) {
  typename SequenceChain<T>::Layers all;
  (all.push_back(std::move(each)), ...);
  return all;
}

extern template class SequenceChain<float>;
extern template class SequenceChain<double>;

}  // namespace piae::nets
