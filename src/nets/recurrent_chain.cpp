#include "nets/recurrent_chain.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/vector.hpp"
#include "nets/row_product.hpp"
#include "nets/weight_gradient.hpp"

namespace piae::nets {

namespace {

/// From rows that hold their frames of `size` numbers one after the other to frames that hold their
/// rows one below the other.
template <class T>
void put_by_frame(Rows<const T> by_row, std::int64_t rows, std::int64_t frames, std::int64_t size,
                  Rows<T> by_frame) {
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    for (std::int64_t row = 0; row < rows; ++row) {
      std::copy_n(by_row.row(row) + frame * size, size, by_frame.row(frame * rows + row));
    }
  }
}

/// The other way round.
template <class T>
void put_by_row(Rows<const T> by_frame, std::int64_t rows, std::int64_t frames, std::int64_t size,
                Rows<T> by_row) {
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    for (std::int64_t row = 0; row < rows; ++row) {
      std::copy_n(by_frame.row(frame * rows + row), size, by_row.row(row) + frame * size);
    }
  }
}

std::string layer_name(const std::string& chain, std::size_t layer) {
  return chain + "/gru" + std::to_string(layer);
}

}  // namespace

template <class T>
RecurrentChain<T>::RecurrentChain(std::shared_ptr<Parameters<T>> parameters,
                                  const std::string& name, FrameCounts frames,
                                  std::int64_t most_rows)
    : parameters_(std::move(parameters)),
      frames_(frames),
      most_rows_(most_rows),
      dense_weight_(parameters_->find(name + "/dense/weight")),
      dense_(dense_weight_) {
  const auto& first = parameters_->find(layer_name(name, 0) + "/input_weight");
  const auto& last = parameters_->find(name + "/dense/bias");
  inputs_ = first.columns;
  begin_ = first.begin;
  dense_bias_ = last.begin - begin_;
  gradients_ = Numbers::Zero(dense_bias_ + last.held_columns);

  const std::int64_t length = std::max(frames.input, frames.output);
  for (const auto& parameter : parameters_->parameters()) {
    const std::string layer = layer_name(name, layers_.size());
    if (parameter.spec.name != layer + "/input_weight") continue;
    const std::int64_t given = layers_.empty() ? frames.input : length;
    layers_.emplace_back(*parameters_, layer, begin_, given, length, most_rows);
  }
  states_.resize(layers_.size());

  const auto rows_with = [&](std::int64_t columns) {
    return Numbers::Zero(most_rows * whole_rows(columns)).eval();
  };
  input_ = input_gradient_ = rows_with(frames.input * inputs_);
  output_ = output_gradient_ = rows_with(frames.output * dense_weight_.rows);
  input_frames_ = input_gradient_frames_ =
      Numbers::Zero(frames.input * most_rows * whole_rows(inputs_));
  output_frames_ = output_gradient_frames_ =
      Numbers::Zero(frames.output * most_rows * whole_rows(dense_weight_.rows));
}

template <class T>
void RecurrentChain<T>::require_room_for(std::int64_t rows) const {
  if (rows > most_rows_) throw std::logic_error("a recurrent chain has no room for so many rows");
}

template <class T>
Rows<const T> RecurrentChain<T>::inputs_of(std::size_t layer) const {
  if (layer > 0) return states_[layer - 1];
  return {input_frames_.data(), whole_rows(inputs_)};
}

template <class T>
Rows<const T> RecurrentChain<T>::read_states(std::int64_t rows) const {
  const std::int64_t length = std::max(frames_.input, frames_.output);
  return states_.back().from((length - frames_.output) * rows);
}

template <class T>
Rows<const T> RecurrentChain<T>::forward(std::int64_t rows) {
  require_room_for(rows);
  put_by_frame<T>(input(), rows, frames_.input, inputs_,
                  {input_frames_.data(), whole_rows(inputs_)});
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    states_[i] = layers_[i].forward(values(), inputs_of(i), rows);
  }

  dense_.renew(values() + dense_weight_.begin - begin_);
  const std::int64_t made = frames_.output * rows;
  const Rows<T> frames{output_frames_.data(), dense_.held_outputs()};
  for (std::int64_t i = 0; i < made; ++i) {
    std::copy_n(values() + dense_bias_, frames.stride, frames.row(i));
  }
  dense_.add(read_states(rows), made, frames);
  const Rows<T> output = rows_of(output_, most_rows_);
  put_by_row<T>(frames, rows, frames_.output, dense_weight_.rows, output);
  return output;
}

template <class T>
Rows<const T> RecurrentChain<T>::backward(std::int64_t rows, std::int64_t signals,
                                          RowRange by_input) {
  require_room_for(signals * rows);
  const Rows<T> by_inputs = rows_of(input_gradient_, most_rows_);
  for (std::int64_t signal = 0; signal < signals; ++signal) {
    const std::int64_t first = signal * rows;
    const bool asked = by_input.begin < first + rows && first < by_input.begin + by_input.count;
    if (signal > 0 && !asked) continue;
    propagate_back(first, rows, signal == 0);
    if (!asked) continue;
    const Rows<T> by_frames{input_gradient_frames_.data(), whole_rows(inputs_)};
    layers_.front().differentiate_inputs(values(), rows, by_frames);
    put_by_row<T>(by_frames, rows, frames_.input, inputs_, by_inputs.from(first));
  }
  return by_inputs.from(by_input.begin);
}

template <class T>
void RecurrentChain<T>::propagate_back(std::int64_t first, std::int64_t rows,
                                       bool with_parameters) {
  const std::int64_t outputs = dense_weight_.rows;
  const std::int64_t held_states = dense_weight_.held_columns;
  const std::int64_t weight = dense_weight_.begin - begin_;
  const Rows<T> dy{output_gradient_frames_.data(), whole_rows(outputs)};
  put_by_frame<T>(output_gradient().from(first), rows, frames_.output, outputs, dy);
  const std::int64_t made = frames_.output * rows;
  GruLayer<T>& last = layers_.back();
  const std::int64_t unread = (std::max(frames_.input, frames_.output) - frames_.output) * rows;
  std::fill_n(last.state_gradient(), unread * held_states, T{0});
  set_product<T>({.a = dy.data,
                  .a_row = dy.stride,
                  .a_column = 1,
                  .b = values() + weight,
                  .b_row = held_states,
                  .c = last.state_gradient() + unread * held_states,
                  .c_row = held_states,
                  .rows = made,
                  .columns = held_states,
                  .depth = outputs});
  if (with_parameters) {
    set_weight_gradient<T>(dy, read_states(rows), made, outputs, held_states,
                           gradients_.data() + weight);
    set_bias_gradient<T>(dy, made, outputs, gradients_.data() + dense_bias_);
  }
  for (std::size_t i = layers_.size(); i-- > 0;) {
    GruLayer<T>& layer = layers_[i];
    layer.backward(values(), rows);
    if (with_parameters) {
      layer.differentiate_parameters(inputs_of(i), rows, gradients_.data());
    }
    if (i > 0) {
      layer.differentiate_inputs(values(), rows,
                                 {layers_[i - 1].state_gradient(), layers_[i - 1].units()});
    }
  }
}

template <class T>
double RecurrentChain<T>::squared_norm() const {
  // In single precision only so far as a sum of this many keeps its digits.
  constexpr std::int64_t together = 4096;
  double sum = 0;
  for (std::int64_t i = 0; i < gradients_.size(); i += together) {
    sum += gradients_.segment(i, std::min(together, gradients_.size() - i)).square().sum();
  }
  return sum;
}

template <class T>
void RecurrentChain<T>::take(const AdamStep& step, double scale) {
  gradients_ *= static_cast<T>(scale);
  nets::take(step, parameters_->data(Kept::value) + begin_, gradients_.data(),
             parameters_->data(Kept::first_moment) + begin_,
             parameters_->data(Kept::second_moment) + begin_,
             static_cast<std::size_t>(gradients_.size()));
}

template class RecurrentChain<float>;
template class RecurrentChain<double>;

}  // namespace piae::nets
