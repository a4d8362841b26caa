#include "nets/dense_chain.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/vector.hpp"

namespace piae::nets {

template <class T>
DenseChain<T>::DenseChain(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
                          std::int64_t most_rows)
    : parameters_(std::move(parameters)), most_rows_(most_rows) {
  std::int64_t widest = 0;
  for (const auto& weight : parameters_->parameters()) {
    if (!weight.spec.name.starts_with(name + "/") || !weight.spec.name.ends_with("/weight")) {
      continue;
    }
    const std::string layer = weight.spec.name.substr(0, weight.spec.name.rfind('/'));
    const LayerSize size{
        .inputs = weight.columns, .outputs = weight.rows, .held_inputs = weight.held_columns};
    const std::int64_t held_outputs = whole_rows(size.outputs);
    layers_.push_back({.size = size,
                       .weight = weight.begin,
                       .bias = parameters_->find(layer + "/bias").begin,
                       .held_outputs = held_outputs,
                       .input = Numbers::Zero(most_rows * size.held_inputs),
                       .output_gradient = Numbers::Zero(most_rows * held_outputs)});
    widest = std::max(widest, size.outputs);
  }
  if (layers_.empty()) throw std::logic_error("no dense layer is called " + name + "/...");
  output_ = Numbers::Zero(most_rows * layers_.back().held_outputs);
  input_gradient_ = Numbers::Zero(most_rows * layers_.front().size.held_inputs);
  no_bias_.resize(static_cast<std::size_t>(widest));
}

template <class T>
void DenseChain<T>::require_room_for(std::int64_t rows) const {
  if (rows > most_rows_) throw std::logic_error("too many rows for a dense chain");
}

template <class T>
Rows<const T> DenseChain<T>::forward(std::int64_t rows) {
  require_room_for(rows);
  rows_ = rows;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    Layer& layer = layers_[i];
    const bool last = i + 1 == layers_.size();
    const Rows<T> output = rows_of(last ? output_ : layers_[i + 1].input, layer.held_outputs);
    propagate<T>(layer.size, values(layer.weight), values(layer.bias), rows,
                 rows_of(layer.input, layer.size.held_inputs), output);
    if (!last) {
      auto batch = layers_[i + 1].input.head(rows * layer.held_outputs);
      batch = batch.max(T{0});
    }
  }
  return rows_of(output_, layers_.back().held_outputs);
}

template <class T>
Rows<const T> DenseChain<T>::backward(std::int64_t rows, std::int64_t signals, RowRange by_input) {
  require_room_for(signals * rows);
  for (std::size_t i = layers_.size() - 1; i > 0; --i) {
    const Layer& layer = layers_[i];
    propagate_back<T>(layer.size, values(layer.weight), signals * rows, output_gradient_of(layer),
                      output_gradient_of(layers_[i - 1]));
    pass_relu_back(i, rows, signals);
  }
  const Layer& first = layers_.front();
  const Rows<T> to = rows_of(input_gradient_, first.size.held_inputs);
  propagate_back<T>(first.size, values(first.weight), by_input.count,
                    output_gradient_of(first).from(by_input.begin), to);
  return to;
}

template <class T>
Rows<const T> DenseChain<T>::backward_and_take(const AdamStep& step, bool by_input) {
  for (std::size_t i = layers_.size(); i-- > 0;) {
    Layer& layer = layers_[i];
    take_bias(layer, step, 1, rows_);
    const Rows<const T> input = rows_of(std::as_const(layer.input), layer.size.held_inputs);
    if (i == 0 && !by_input) {
      nets::take<T>(step, 1, layer.size, rows_, output_gradient_of(layer), input,
                    trained(layer.weight));
      break;
    }
    const Rows<T> to = i == 0 ? rows_of(input_gradient_, layer.size.held_inputs)
                              : output_gradient_of(layers_[i - 1]);
    propagate_back_and_take<T>(step, layer.size, rows_, output_gradient_of(layer), input,
                               trained(layer.weight), to);
    if (i > 0) pass_relu_back(i, rows_, 1);
  }
  return rows_of(input_gradient_, layers_.front().size.held_inputs);
}

template <class T>
void DenseChain<T>::pass_relu_back(std::size_t i, std::int64_t rows, std::int64_t signals) {
  const Layer& layer = layers_[i];
  const std::int64_t size = rows * layer.size.held_inputs;
  for (std::int64_t signal = 0; signal < signals; ++signal) {
    auto gradient = layers_[i - 1].output_gradient.segment(signal * size, size);
    gradient = (layer.input.head(size) > T{0}).select(gradient, T{0});
  }
}

template <class T>
void DenseChain<T>::forward_derivative(std::int64_t first, std::int64_t rows) {
  require_room_for(first + rows);
  for (std::size_t i = 0; i + 1 < layers_.size(); ++i) {
    const Layer& layer = layers_[i];
    Numbers derivative = Numbers::Zero(rows * layer.held_outputs);
    propagate<T>(layer.size, values(layer.weight), no_bias_.data(), rows,
                 rows_of(layer.input, layer.size.held_inputs).from(first),
                 {derivative.data(), layer.held_outputs});
    auto given = layers_[i + 1].input.segment(first * layer.held_outputs, derivative.size());
    given = (given > T{0}).select(derivative, T{0});
  }
}

template <class T>
std::vector<T> DenseChain<T>::bias_gradient(const Layer& layer, std::int64_t rows) const {
  std::vector<T> sums(static_cast<std::size_t>(layer.size.outputs));
  const Rows<const T> gradients = output_gradient_of(layer);
  for (std::int64_t r = 0; r < rows; ++r) {
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += gradients.row(r)[j];
  }
  return sums;
}

template <class T>
double DenseChain<T>::squared_norm(const Summed& rows) const {
  double sum = 0;
  for (const Layer& layer : layers_) {
    sum += nets::squared_norm<T>(layer.size, rows.of_weights, output_gradient_of(layer),
                                 rows_of(layer.input, layer.size.held_inputs));
    for (const T x : bias_gradient(layer, rows.of_biases)) sum += static_cast<double>(x) * x;
  }
  return sum;
}

template <class T>
TrainedWeight<T> DenseChain<T>::trained(std::int64_t begin) {
  return {.values = parameters_->data(Kept::value) + begin,
          .first_moment = parameters_->data(Kept::first_moment) + begin,
          .second_moment = parameters_->data(Kept::second_moment) + begin};
}

template <class T>
void DenseChain<T>::take_bias(const Layer& layer, const AdamStep& step, double scale,
                              std::int64_t rows) {
  std::vector<T> bias = bias_gradient(layer, rows);
  for (T& x : bias) x *= static_cast<T>(scale);
  const TrainedWeight<T> to = trained(layer.bias);
  nets::take(step, to.values, bias.data(), to.first_moment, to.second_moment, bias.size());
}

template <class T>
void DenseChain<T>::take(const AdamStep& step, double scale, const Summed& rows) {
  for (Layer& layer : layers_) {
    take_bias(layer, step, scale, rows.of_biases);
    nets::take<T>(step, scale, layer.size, rows.of_weights, output_gradient_of(layer),
                  rows_of(layer.input, layer.size.held_inputs), trained(layer.weight));
  }
}

template class DenseChain<float>;
template class DenseChain<double>;

}  // namespace piae::nets
