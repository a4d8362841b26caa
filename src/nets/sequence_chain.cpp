#include "nets/sequence_chain.hpp"

#include <stdexcept>

namespace piae::nets {

namespace {

/// Returns the input shape of the first layer and the output shape of the last. Throws
/// std::logic_error if layers do not fit.
template <class T>
std::pair<SequenceShape, SequenceShape> ends_of(
    const std::vector<std::unique_ptr<SequenceLayer<T>>>& layers) {
  if (layers.empty()) throw std::logic_error("a chain needs at least one layer");
  for (std::size_t i = 1; i < layers.size(); ++i) {
    if (layers[i - 1]->output().size() != layers[i]->input().size()) {
      throw std::logic_error("two successive layers of a chain differ in size");
    }
  }
  return {layers.front()->input(), layers.back()->output()};
}

}  // namespace

template <class T>
SequenceChain<T>::SequenceChain(Layers layers)
    : SequenceLayer<T>(ends_of(layers)), layers_(std::move(layers)), between_(layers_.size() - 1) {}

template <class T>
void SequenceChain<T>::forward(std::int64_t windows, const T* x, T* y) {
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const bool last = i + 1 == layers_.size();
    T* const to = last ? y : room_for(windows * layers_[i]->output().size(), between_[i]);
    layers_[i]->forward(windows, x, to);
    x = to;
  }
}

template <class T>
void SequenceChain<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  for (std::size_t i = layers_.size(); i-- > 0;) {
    SequenceLayer<T>& layer = *layers_[i];
    T* const to = i == 0 ? dx : room_for(batch.all() * layer.input().size(), gradients_[i % 2]);
    layer.backward(batch, i == 0 ? x : between_[i - 1].data(), dy, to);
    dy = to;
  }
}

template class SequenceChain<float>;
template class SequenceChain<double>;

}  // namespace piae::nets
