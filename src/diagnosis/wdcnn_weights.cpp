#include "diagnosis/wdcnn_weights.hpp"

#include <algorithm>
#include <cmath>

#include "nets/stored_parameters.hpp"

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

std::string statistic(const std::string& group, std::size_t layer, const char* name) {
  return group + "/" + layer_name(layer) + "/" + name;
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

void write(artefact::Writer& writer, const std::string& group, const WdcnnWeights& weights) {
  nets::write_parameters(writer, group, wdcnn_parameters(weights.length, weights.classes),
                         weights.parameters);
  for (std::size_t i = 0; i < layers_with_normalisation; ++i) {
    writer.numbers(statistic(group, i, "running_mean"), weights.running_means.at(i));
    writer.numbers(statistic(group, i, "running_variance"), weights.running_variances.at(i));
  }
}

WdcnnWeights read_wdcnn_weights(const artefact::Reader& reader, const std::string& group,
                                std::int64_t length, std::int64_t classes) {
  WdcnnWeights weights{
      .length = length,
      .classes = classes,
      .parameters = nets::read_parameters(reader, group, wdcnn_parameters(length, classes)),
      .running_means = {},
      .running_variances = {}};
  for (std::size_t i = 0; i < layers_with_normalisation; ++i) {
    const auto read = [&](const char* name) {
      return reader.numbers<float>(statistic(group, i, name), {layer_channels(i)}).values;
    };
    weights.running_means.push_back(read("running_mean"));
    weights.running_variances.push_back(read("running_variance"));
    if (std::ranges::min(weights.running_variances.back()) < 0) {
      reader.refuse(statistic(group, i, "running_variance"), "has a variance below 0");
    }
  }
  return weights;
}

}  // namespace piae::diagnosis
