#include "diagnosis/wdcnn_layout.hpp"

#include "base/vector.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "diagnosis/wdcnn_weights.hpp"

namespace piae::diagnosis {

namespace {

/// Returns the inputs of one tap: the channels of the previous layer. The dense layer reads these
/// at several times; each time is a tap.
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
    // The first convolution has one input and reads several samples at a time as channels
    // (wdcnn_network.cpp), so it is not padded.
    const std::int64_t held_inputs = inputs == 1 ? 1 : whole_rows(inputs);
    layout.push_back({.spec = spec,
                      .begin = begin,
                      .outputs = outputs,
                      .inputs = inputs,
                      .taps = taps,
                      .held_inputs = held_inputs,
                      .held_outputs = whole_rows(outputs)});
    begin += layout.back().held_size();
  }
  return layout;
}

}  // namespace piae::diagnosis
