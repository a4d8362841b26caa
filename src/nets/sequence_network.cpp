#include "nets/sequence_network.hpp"

#include <stdexcept>
#include <utility>

namespace piae::nets {

template <class T>
SequenceNetwork<T>::SequenceNetwork(std::unique_ptr<GradientArray<T>> parameters,
                                    std::unique_ptr<SequenceLayer<T>> layers,
                                    std::int64_t most_rows)
    : parameters_(std::move(parameters)),
      layers_(std::move(layers)),
      most_rows_(most_rows),
      input_(Eigen::ArrayX<T>::Zero(most_rows * layers_->input().size())),
      output_(Eigen::ArrayX<T>::Zero(most_rows * layers_->output().size())),
      output_gradient_(Eigen::ArrayX<T>::Zero(most_rows * layers_->output().size())) {}

template <class T>
void SequenceNetwork<T>::require_room_for(std::int64_t rows) const {
  if (rows > most_rows_) throw std::logic_error("too many rows for a network");
}

template <class T>
Rows<const T> SequenceNetwork<T>::forward(std::int64_t rows) {
  require_room_for(rows);
  layers_->forward(rows, input_.data(), output_.data());
  return {output_.data(), layers_->output().size()};
}

template <class T>
Rows<const T> SequenceNetwork<T>::backward(std::int64_t rows, std::int64_t signals,
                                           RowRange by_input) {
  require_room_for(signals * rows);
  const std::int64_t stride = layers_->input().size();
  // Skip unused signals: the parameters follow the first signal, and later ones matter only up to
  // the last requested row.
  const std::int64_t followed =
      by_input.count > 0 ? (by_input.begin + by_input.count - 1) / rows + 1 : 1;
  T* const to = by_input.count > 0 ? room_for(followed * rows * stride, input_gradient_) : nullptr;
  layers_->backward({.windows = rows, .signals = followed}, input_.data(), output_gradient_.data(),
                    to);
  return Rows<const T>{to, stride}.from(to == nullptr ? 0 : by_input.begin);
}

template class SequenceNetwork<float>;
template class SequenceNetwork<double>;

}  // namespace piae::nets
