#include "nets/convolutional_chain.hpp"

#include <algorithm>
#include <stdexcept>

namespace piae::nets {

template <class T>
ConvolutionalChain<T>::ConvolutionalChain(const std::shared_ptr<Parameters<T>>& parameters,
                                          const std::string& name, ConvolutionKind kind,
                                          std::int64_t input_length, std::int64_t most_rows)
    : most_rows_(most_rows) {
  std::int64_t padding = 0;
  for (const auto& weight : parameters->parameters()) {
    if (!weight.spec.name.starts_with(name + "/conv") || !weight.spec.name.ends_with("/weight")) {
      continue;
    }
    const std::string layer = weight.spec.name.substr(0, weight.spec.name.rfind('/'));
    const std::int64_t length = layers_.empty() ? input_length : layers_.back().output_length();
    layers_.emplace_back(parameters, layer, kind, length);
    padding = std::max(padding, layers_.back().shape().padding());
  }
  if (layers_.empty()) throw std::logic_error("no convolution is called " + name + "/...");
  const auto add = [&](std::int64_t length, std::int64_t channels) {
    signals_.emplace_back(most_rows, length, channels, padding);
    gradients_.emplace_back(most_rows, length, channels, padding);
  };
  add(input_length, layers_.front().inputs());
  for (const auto& layer : layers_) add(layer.output_length(), layer.outputs());
}

template <class T>
void ConvolutionalChain<T>::require_room_for(std::int64_t rows) const {
  if (rows > most_rows_) throw std::logic_error("convolutions have no room for so many rows");
}

template <class T>
Rows<const T> ConvolutionalChain<T>::forward(std::int64_t rows) {
  require_room_for(rows);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    PaddedBatch<T>& output = signals_[i + 1];
    layers_[i].forward(rows, signals_[i].rows(), output.rows());
    if (i + 1 < layers_.size()) {
      auto batch = output.all(0, rows);
      batch = batch.max(T{0});
    }
  }
  return signals_.back().rows();
}

template <class T>
Rows<const T> ConvolutionalChain<T>::backward(std::int64_t rows, std::int64_t signals,
                                              RowRange by_input) {
  require_room_for(signals * rows);
  for (std::size_t i = layers_.size() - 1; i > 0; --i) {
    layers_[i].differentiate(rows, signals_[i].rows(), gradients_[i + 1].rows());
    layers_[i].propagate_back(signals * rows, gradients_[i + 1].rows(), gradients_[i].rows());
    const auto given = signals_[i].all(0, rows);
    for (std::int64_t signal = 0; signal < signals; ++signal) {
      auto gradient = gradients_[i].all(signal * rows, rows);
      gradient = (given > T{0}).select(gradient, T{0});
    }
  }
  layers_.front().differentiate(rows, signals_[0].rows(), gradients_[1].rows());
  layers_.front().propagate_back(by_input.count, gradients_[1].rows().from(by_input.begin),
                                 gradients_[0].rows());
  return gradients_[0].rows();
}

template <class T>
double ConvolutionalChain<T>::squared_norm() const {
  double sum = 0;
  for (const auto& layer : layers_) sum += layer.squared_norm();
  return sum;
}

template <class T>
void ConvolutionalChain<T>::take(const AdamStep& step, double scale) {
  for (auto& layer : layers_) layer.take(step, scale);
}

template class ConvolutionalChain<float>;
template class ConvolutionalChain<double>;

}  // namespace piae::nets
