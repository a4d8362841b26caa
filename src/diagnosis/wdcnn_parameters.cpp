#include "diagnosis/wdcnn_parameters.hpp"

#include <cmath>

#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

/// Weight, and scale and shift of the batch normalisation that follows.
void add_normalised_layer(std::vector<nets::ParameterSpec>& specs, const std::string& name,
                          const std::vector<std::int64_t>& shape, std::int64_t fan_in) {
  specs.push_back({name + "/weight", shape, 1 / std::sqrt(static_cast<double>(fan_in))});
  specs.push_back({name + "/scale", {shape[0]}, 0, 1});
  specs.push_back({name + "/shift", {shape[0]}, 0, 0});
}

}  // namespace

std::string layer_name(std::size_t i) {
  return i < WdcnnLayers::convolutions.size() ? "conv" + std::to_string(i + 1) : "dense";
}

std::vector<nets::ParameterSpec> wdcnn_parameters(std::int64_t length, std::int64_t classes) {
  std::vector<nets::ParameterSpec> specs;
  for (std::size_t i = 0; i < WdcnnLayers::convolutions.size(); ++i) {
    const Convolution& c = WdcnnLayers::convolutions[i];
    add_normalised_layer(specs, layer_name(i), {c.outputs, c.inputs, c.width}, c.fan_in());
  }
  const std::int64_t features = WdcnnLayers::features(length);
  add_normalised_layer(specs, "dense", {WdcnnLayers::hidden, features}, features);
  for (nets::ParameterSpec& spec : nets::dense_specs("classes", WdcnnLayers::hidden, classes)) {
    specs.push_back(std::move(spec));
  }
  return specs;
}

}  // namespace piae::diagnosis
