#include "nets/gru_layer.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/vector.hpp"
#include "nets/gru_gates.hpp"
#include "nets/weight_gradient.hpp"

namespace piae::nets {

template <class T>
GruLayer<T>::GruLayer(const Parameters<T>& parameters, const std::string& name, std::int64_t origin,
                      std::int64_t input_frames, std::int64_t frames, std::int64_t most_rows)
    : input_frames_(input_frames),
      frames_(frames),
      units_(parameters.find(name + "/state_weight").columns),
      held_inputs_(parameters.find(name + "/input_weight").held_columns),
      at_{.input_weight = parameters.find(name + "/input_weight").begin - origin,
          .state_weight = parameters.find(name + "/state_weight").begin - origin,
          .input_bias = parameters.find(name + "/input_bias").begin - origin,
          .state_bias = parameters.find(name + "/state_bias").begin - origin},
      input_weight_(parameters.find(name + "/input_weight")),
      state_weight_(parameters.find(name + "/state_weight")) {
  if (units_ % row_granule != 0) {
    throw std::logic_error(name + ": recurrent units must fill whole vectors");
  }
  const std::int64_t size = most_rows * units_;
  x_ = Numbers::Zero(3 * input_frames * size);
  product_ = Numbers::Zero(3 * size);
  gates_ = Numbers::Zero(4 * frames * size);
  states_ = Numbers::Zero((1 + frames) * size);
  state_gradient_ = Numbers::Zero(frames * size);
  carried_ = Numbers::Zero(size);
  by_x_ = Numbers::Zero(3 * frames * size);
  by_product_ = Numbers::Zero(3 * frames * size);
}

template <class T>
Rows<const T> GruLayer<T>::forward(const T* values, Rows<const T> inputs, std::int64_t rows) {
  input_weight_.renew(values + at_.input_weight);
  state_weight_.renew(values + at_.state_weight);
  for (std::int64_t i = 0; i < input_frames_ * rows; ++i) {
    std::copy_n(values + at_.input_bias, 3 * units_, x_.data() + i * 3 * units_);
  }
  input_weight_.add(inputs, input_frames_ * rows, {x_.data(), 3 * units_});

  const std::int64_t size = rows * units_;  // of the states at one frame
  states_.head(size).setZero();
  product_.head(3 * size).setZero();
  for (std::int64_t frame = 0; frame < frames_; ++frame) {
    const T* const before = states_.data() + frame * size;
    if (frame > 0) state_weight_.set({before, units_}, rows, {product_.data(), 3 * units_});
    open_gates<T>({.rows = rows,
                   .units = units_,
                   .x = x_.data() + (input_frames_ > 1 ? frame : 0) * 3 * size,
                   .product = product_.data(),
                   .state_bias = values + at_.state_bias,
                   .before = before,
                   .gates = gates_.data() + frame * 4 * size,
                   .state = states_.data() + (frame + 1) * size});
  }
  return {states_.data() + size, units_};
}

template <class T>
void GruLayer<T>::backward(const T* values, std::int64_t rows) {
  const std::int64_t size = rows * units_;
  carried_.head(size).setZero();
  for (std::int64_t frame = frames_ - 1; frame >= 0; --frame) {
    T* const by_product = by_product_.data() + frame * 3 * size;
    differentiate_gates<T>({.rows = rows,
                            .units = units_,
                            .gates = gates_.data() + frame * 4 * size,
                            .before = states_.data() + frame * size,
                            .by_state = state_gradient_.data() + frame * size,
                            .carried = carried_.data(),
                            .by_x = by_x_.data() + frame * 3 * size,
                            .by_product = by_product});
    if (frame == 0) break;
    add_product<T>({.a = by_product,
                    .a_row = 3 * units_,
                    .a_column = 1,
                    .b = values + at_.state_weight,
                    .b_row = units_,
                    .c = carried_.data(),
                    .c_row = units_,
                    .rows = rows,
                    .columns = units_,
                    .depth = 3 * units_});
  }
  for (std::int64_t frame = input_frames_; frame < frames_; ++frame) {
    by_x_.head(3 * size) += by_x_.segment(frame * 3 * size, 3 * size);
  }
}

template <class T>
void GruLayer<T>::differentiate_inputs(const T* values, std::int64_t rows,
                                       Rows<T> by_inputs) const {
  set_product<T>({.a = by_x_.data(),
                  .a_row = 3 * units_,
                  .a_column = 1,
                  .b = values + at_.input_weight,
                  .b_row = held_inputs_,
                  .c = by_inputs.data,
                  .c_row = by_inputs.stride,
                  .rows = input_frames_ * rows,
                  .columns = held_inputs_,
                  .depth = 3 * units_});
}

template <class T>
void GruLayer<T>::differentiate_parameters(Rows<const T> inputs, std::int64_t rows,
                                           T* gradients) const {
  const Rows<const T> by_x{by_x_.data(), 3 * units_};
  const Rows<const T> by_product{by_product_.data(), 3 * units_};
  const std::int64_t given = input_frames_ * rows;
  const std::int64_t all = frames_ * rows;
  set_weight_gradient<T>(by_x, inputs, given, 3 * units_, held_inputs_,
                         gradients + at_.input_weight);
  set_bias_gradient<T>(by_x, given, 3 * units_, gradients + at_.input_bias);
  // At rest, before frame 0, the state is zero and adds nothing.
  set_weight_gradient<T>(by_product.from(rows), {states_.data() + rows * units_, units_},
                         all - rows, 3 * units_, units_, gradients + at_.state_weight);
  set_bias_gradient<T>(by_product, all, 3 * units_, gradients + at_.state_bias);
}

template class GruLayer<float>;
template class GruLayer<double>;

}  // namespace piae::nets
