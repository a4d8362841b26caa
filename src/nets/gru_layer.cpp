#include "nets/gru_layer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/vector.hpp"
#include "nets/gru_gates.hpp"

namespace piae::nets {

std::vector<ParameterSpec> gru_specs(const std::string& name, std::int64_t inputs,
                                     std::int64_t units) {
  const double bound = 1 / std::sqrt(static_cast<double>(units));
  return {{name + "/input_weight", {3 * units, inputs}, bound},
          {name + "/state_weight", {3 * units, units}, bound},
          {name + "/input_bias", {3 * units}, bound},
          {name + "/state_bias", {3 * units}, bound}};
}

template <class T>
GruLayer<T>::GruLayer(GradientArray<T>& parameters, const std::string& name,
                      std::int64_t input_length, std::int64_t length)
    : SequenceLayer<T>(
          {.length = input_length, .width = parameters.find(name + "/input_weight").held_columns},
          {.length = length, .width = parameters.find(name + "/state_weight").columns}),
      input_weight_(parameters.find(name + "/input_weight")),
      state_weight_(parameters.find(name + "/state_weight")),
      input_bias_(parameters.find(name + "/input_bias")),
      state_bias_(parameters.find(name + "/state_bias")) {
  if (units() % row_granule != 0)
    throw std::logic_error("the units of " + name + " do not fill whole rows");
  if (input_length != 1 && input_length != length) {
    throw std::logic_error(name + " needs one input, or one for each position");
  }
}

template <class T>
void GruLayer<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t given = windows * this->input().length;
  T* const inputs = room_for(given * 3 * units(), x_);
  input_weight_.renew();
  input_weight_.forward(given, {x, this->input().width}, {inputs, 3 * units()});
  add_bias(input_bias_, given, 3 * units(), inputs);

  room_for(windows * 3 * units(), product_);
  room_for(windows * length() * 4 * units(), gates_);
  room_for(windows * length() * units(), before_);
  product_.setZero();  // the initial state is 0
  for (std::int64_t w = 0; w < windows; ++w) {
    std::fill_n(at(before_.data(), 0, units()).row(w), units(), T{0});
  }
  state_weight_.renew();
  for (std::int64_t t = 0; t < length(); ++t) {
    const Rows<const T> before =
        t == 0 ? at(std::as_const(before_).data(), 0, units()) : at<const T>(y, t - 1, units());
    const Rows<T> product{product_.data(), 3 * units()};
    if (t > 0) state_weight_.forward(windows, before, product);
    const std::int64_t input = this->input().length > 1 ? t : 0;
    open_gates<T>({.rows = windows,
                   .units = units(),
                   .x = {inputs + input * 3 * units(), this->input().length * 3 * units()},
                   .product = product,
                   .state_bias = state_bias_.values,
                   .before = before,
                   .gates = at(gates_.data(), t, 4 * units()),
                   .state = at(y, t, units())});
  }
  const std::int64_t size = this->output().size();
  for (std::int64_t w = 0; w < windows; ++w) {
    std::copy_n(y + w * size, size - units(), before_.data() + w * size + units());
  }
}

template <class T>
void GruLayer<T>::differentiate_states(const SignalBatch& batch, const T* dy) {
  const std::int64_t size = batch.all() * length() * 3 * units();
  T* const by_x = room_for(size, by_x_);
  T* const by_product = room_for(size, by_product_);
  T* const carried = room_for(batch.all() * units(), carried_);
  carried_.setZero();
  for (std::int64_t t = length() - 1; t >= 0; --t) {
    for (std::int64_t signal = 0; signal < batch.signals; ++signal) {
      const std::int64_t first = signal * batch.windows;
      differentiate_gates<T>({.rows = batch.windows,
                              .units = units(),
                              .gates = at<const T>(gates_.data(), t, 4 * units()),
                              .before = at<const T>(before_.data(), t, units()),
                              .by_state = at(dy, t, units()).from(first),
                              .carried = Rows<T>{carried, units()}.from(first),
                              .by_x = at(by_x, t, 3 * units()).from(first),
                              .by_product = at(by_product, t, 3 * units()).from(first)});
    }
    if (t > 0) {
      state_weight_.backward(batch.all(), at<const T>(by_product, t, 3 * units()),
                             {carried, units()}, true);
    }
  }
}

template <class T>
void GruLayer<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  differentiate_states(batch, dy);
  const std::int64_t width = 3 * units();
  const std::int64_t all = batch.windows * length();
  state_weight_.differentiate(all, {before_.data(), units()}, {by_product_.data(), width});
  differentiate_bias(state_bias_, all, width, std::as_const(by_product_).data());

  if (this->input().length < length()) {  // gradients by a shared input are sums over all positions
    for (std::int64_t w = 0; w < batch.all(); ++w) {
      const T* const from = by_x_.data() + w * length() * width;
      as_matrix(by_x_.data() + w * width, 1, width) =
          as_matrix(from, length(), width).colwise().sum().eval();
    }
  }
  const std::int64_t given = batch.windows * this->input().length;
  const Rows<const T> by_x{by_x_.data(), width};
  input_weight_.differentiate(given, {x, this->input().width}, by_x);
  differentiate_bias(input_bias_, given, width, by_x.data);
  if (dx != nullptr) {
    input_weight_.backward(batch.signals * given, by_x, {dx, this->input().width});
  }
}

template class GruLayer<float>;
template class GruLayer<double>;

}  // namespace piae::nets
