#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::diagnosis {

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
