#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::diagnosis {

/// Returns the name of the i-th layer with batch normalisation: "conv1" to "conv5" for 0 to 4,
/// "dense" for 5.
std::string layer_name(std::size_t i);

/// Number of layers with batch normalisation, and the channels of each.
inline constexpr std::size_t layers_with_normalisation = WdcnnLayers::convolutions.size() + 1;
std::size_t layer_channels(std::size_t i);

/// Returns the parameters of WDCNN for windows of `length` samples. For conv1 to conv5:
/// conv1/weight [outputs, inputs, width], and conv1/scale and conv1/shift [outputs] of its batch
/// normalisation. Then dense/weight [100, features], dense/scale, dense/shift, classes/weight
/// [classes, 100] and classes/bias. Features are in the order [channel, time]. Weights and the bias
/// start uniform in +-1/sqrt(inputs of a unit), as LibTorch's layers do, scales at 1 and shifts at
/// 0.
std::vector<nets::ParameterSpec> wdcnn_parameters(std::int64_t length, std::int64_t classes);

/// All learned numbers of a WDCNN.
struct WdcnnWeights {
  /// Samples in a window, and number of classes.
  std::int64_t length = 0;
  std::int64_t classes = 0;
  /// The parameters one after another, in the order of wdcnn_parameters().
  std::vector<float> parameters;
  /// Running statistics of the layers with batch normalisation, [channels] each, in the order of
  /// layer_name().
  std::vector<std::vector<float>> running_means;
  std::vector<std::vector<float>> running_variances;
};

/// Writes datasets below a group: <group>/conv1/weight, .../scale, .../shift, .../running_mean and
/// .../running_variance, to conv5 and dense, then <group>/classes/weight and .../bias.
void write(artefact::Writer& writer, const std::string& group, const WdcnnWeights& weights);
/// Throws artefact::Refusal if a dataset is missing or has another shape, and for a variance below
/// 0.
WdcnnWeights read_wdcnn_weights(const artefact::Reader& reader, const std::string& group,
                                std::int64_t length, std::int64_t classes);

}  // namespace piae::diagnosis
