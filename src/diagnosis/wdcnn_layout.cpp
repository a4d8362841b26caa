#include "diagnosis/wdcnn_layout.hpp"

#include "base/vector.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "diagnosis/wdcnn_parameters.hpp"

namespace piae::diagnosis {

namespace {

/// Inputs of one tap: channels of the layer before, of which the dense layer reads several times.
std::int64_t inputs_of(const nets::ParameterSpec& spec) {
  if (spec.shape.size() == 1) return 1;
  return spec.name == "dense/weight" ? WdcnnLayers::convolutions.back().outputs : spec.shape[1];
}

}  // namespace

std::vector<WdcnnParameter> wdcnn_layout(std::int64_t length, std::int64_t classes) {
  std::vector<WdcnnParameter> layout;
  std::int64_t begin = 0;
  for (const nets::ParameterSpec& spec : wdcnn_parameters(length, classes)) {
    const std::int64_t outputs = spec.shape[0];
    const std::int64_t inputs = inputs_of(spec);
    const std::int64_t taps = spec.size() / (outputs * inputs);
    // The one input of the first convolution is read as many at a time (native_network.cpp).
    const std::int64_t held_inputs = inputs == 1 ? 1 : whole_rows(inputs);
    layout.push_back({spec, begin, outputs, inputs, taps, held_inputs, whole_rows(outputs)});
    begin += layout.back().held_size();
  }
  return layout;
}

}  // namespace piae::diagnosis
