#include "diagnosis/wdcnn_weights.hpp"

#include <algorithm>

#include "diagnosis/wdcnn_parameters.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::diagnosis {

namespace {

std::string statistic(const std::string& group, std::size_t layer, const char* name) {
  return group + "/" + layer_name(layer) + "/" + name;
}

}  // namespace

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
