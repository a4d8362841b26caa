#include "nets/gru_gates.hpp"

#include "base/vector.hpp"
#include "nets/sigmoid.hpp"

namespace piae::nets {

template <class T>
void open_gates(const GatesForward<T>& frame) {
  const std::int64_t units = frame.units;
  for (std::int64_t row = 0; row < frame.rows; ++row) {
    const T* const x = frame.x.row(row);
    const T* const product = frame.product.row(row);
    const T* const before = frame.before.row(row);
    T* const gates = frame.gates.row(row);
    T* const state = frame.state.row(row);
    for (std::int64_t j = 0; j < units; j += lanes<T>) {
      const auto of_state = [&](std::int64_t gate) {
        return load(product + gate * units + j) + load(frame.state_bias + gate * units + j);
      };
      const Vector<T> r = sigmoid<T>(load(x + j) + of_state(0));
      const Vector<T> z = sigmoid<T>(load(x + units + j) + of_state(1));
      const Vector<T> h_n = of_state(2);
      const Vector<T> n = tanh<T>(load(x + 2 * units + j) + r * h_n);
      store<T>(gates + j, r);
      store<T>(gates + units + j, z);
      store<T>(gates + 2 * units + j, n);
      store<T>(gates + 3 * units + j, h_n);
      store<T>(state + j, n + z * (load(before + j) - n));
    }
  }
}

template <class T>
void differentiate_gates(const GatesBackward<T>& frame) {
  const std::int64_t units = frame.units;
  for (std::int64_t row = 0; row < frame.rows; ++row) {
    const T* const gates = frame.gates.row(row);
    const T* const before = frame.before.row(row);
    const T* const by_state = frame.by_state.row(row);
    T* const carried = frame.carried.row(row);
    T* const by_x = frame.by_x.row(row);
    T* const by_product = frame.by_product.row(row);
    for (std::int64_t j = 0; j < units; j += lanes<T>) {
      const Vector<T> r = load(gates + j);
      const Vector<T> z = load(gates + units + j);
      const Vector<T> n = load(gates + 2 * units + j);
      const Vector<T> h_n = load(gates + 3 * units + j);
      const Vector<T> by_h = load(by_state + j) + load(carried + j);
      const Vector<T> by_n = by_h * (T{1} - z) * (T{1} - n * n);
      const Vector<T> by_z = by_h * (load(before + j) - n) * z * (T{1} - z);
      const Vector<T> by_r = by_n * h_n * r * (T{1} - r);
      store<T>(carried + j, by_h * z);
      store<T>(by_x + j, by_r);
      store<T>(by_x + units + j, by_z);
      store<T>(by_x + 2 * units + j, by_n);
      store<T>(by_product + j, by_r);
      store<T>(by_product + units + j, by_z);
      store<T>(by_product + 2 * units + j, by_n * r);
    }
  }
}

template void open_gates(const GatesForward<float>&);
template void open_gates(const GatesForward<double>&);
template void differentiate_gates(const GatesBackward<float>&);
template void differentiate_gates(const GatesBackward<double>&);

}  // namespace piae::nets
