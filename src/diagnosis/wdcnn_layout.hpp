#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nets/parameter_spec.hpp"

namespace piae::diagnosis {

/// Place of a parameter of WDCNN (wdcnn_weights.hpp) in the single array of our own back end. It
/// is stored as [tap, input, output], with inputs and outputs padded to whole vectors by zeros.
/// These zeros and their gradients stay zero.
struct WdcnnParameter {
  nets::ParameterSpec spec;  ///< its shape is [outputs, inputs * taps], or [outputs] for a vector
  std::int64_t begin;        ///< index of its first number in the array
  std::int64_t outputs;
  std::int64_t inputs;        ///< 1 for a vector
  std::int64_t taps;          ///< 1 for a vector
  std::int64_t held_inputs;   ///< inputs with padding
  std::int64_t held_outputs;  ///< outputs with padding

  [[nodiscard]] std::int64_t held_size() const { return taps * held_inputs * held_outputs; }

  /// Calls f(i, j) for each number of the parameter: i is its index in the order of the spec, j its
  /// index in the array.
  template <class Function>
  void for_each(const Function& f) const {
    std::int64_t i = 0;
    for (std::int64_t output = 0; output < outputs; ++output) {
      for (std::int64_t input = 0; input < inputs; ++input) {
        for (std::int64_t tap = 0; tap < taps; ++tap) {
          f(i++, begin + (tap * held_inputs + input) * held_outputs + output);
        }
      }
    }
  }
};

/// Returns the layout of all parameters, in the order of wdcnn_parameters(length, classes).
std::vector<WdcnnParameter> wdcnn_layout(std::int64_t length, std::int64_t classes);

}  // namespace piae::diagnosis
