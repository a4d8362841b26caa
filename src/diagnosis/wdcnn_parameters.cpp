#include "diagnosis/wdcnn_parameters.hpp"

#include <cmath>

namespace piae::diagnosis {

namespace {

/// Adds the weight of a layer, and scale and shift of its batch normalisation.
void add_normalised_layer(std::vector<nets::ParameterSpec>& specs, const std::string& name,
                          const std::vector<std::int64_t>& shape, std::int64_t fan_in) {
  specs.push_back({.name = name + "/weight",
                   .shape = shape,
                   .bound = 1 / std::sqrt(static_cast<double>(fan_in))});
  specs.push_back({.name = name + "/scale", .shape = {shape[0]}, .constant = 1});
  specs.push_back({.name = name + "/shift", .shape = {shape[0]}, .constant = 0});
}

}  // namespace

std::string layer_name(std::size_t i) {
  return i < WdcnnLayers::convolutions.size() ? "conv" + std::to_string(i + 1) : "dense";
}

std::size_t layer_channels(std::size_t i) {
  return static_cast<std::size_t>(i < WdcnnLayers::convolutions.size()
                                      ? WdcnnLayers::convolutions[i].outputs
                                      : WdcnnLayers::hidden);
}

std::vector<nets::ParameterSpec> wdcnn_parameters(std::int64_t length, std::int64_t classes) {
  std::vector<nets::ParameterSpec> specs;
  for (std::size_t i = 0; i < WdcnnLayers::convolutions.size(); ++i) {
    const Convolution& c = WdcnnLayers::convolutions[i];
    add_normalised_layer(specs, layer_name(i), {c.outputs, c.inputs, c.width}, c.fan_in());
  }
  const std::int64_t features = WdcnnLayers::features(length);
  add_normalised_layer(specs, "dense", {WdcnnLayers::hidden, features}, features);
  append(specs, nets::dense_specs("classes", WdcnnLayers::hidden, classes));
  return specs;
}

}  // namespace piae::diagnosis
