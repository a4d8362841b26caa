#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nets/parameter_spec.hpp"

namespace piae::diagnosis {

/// Where a parameter of WDCNN (wdcnn_parameters.hpp) lies in the native back end's flat vector: as
/// [tap, input, output], with inputs and outputs filled up to whole vectors. What fills them is and
/// stays zero, as are its gradients.
struct WdcnnParameter {
  nets::ParameterSpec spec;
  std::int64_t begin;  ///< in the flat vector
  std::int64_t
      outputs;  ///< spec.shape is [outputs, inputs * taps]; 1 input and tap without weights
  std::int64_t inputs;
  std::int64_t taps;
  std::int64_t held_inputs;
  std::int64_t held_outputs;

  [[nodiscard]] std::int64_t held_size() const { return taps * held_inputs * held_outputs; }

  /// Calls f(i, j) with each of its numbers' place i in spec's order and place j in the flat
  /// vector.
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

/// In the order of wdcnn_parameters(length, classes).
std::vector<WdcnnParameter> wdcnn_layout(std::int64_t length, std::int64_t classes);

}  // namespace piae::diagnosis
