#include "twin/temporal_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "nets/dilated_convolution.hpp"
#include "nets/position_dense.hpp"
#include "nets/position_mean.hpp"
#include "nets/relu.hpp"
#include "nets/residual.hpp"

namespace piae::twin {

namespace {

using nets::GradientArray;

constexpr std::int64_t most_blocks = 9;  // the last has a dilation of 65 536

std::string block_name(std::int64_t i) { return fmt::format("block{}", i); }

/// Returns F of a residual block.
template <class T>
std::unique_ptr<nets::SequenceLayer<T>> temporal_branch(GradientArray<T>& parameters,
                                                        const std::string& name,
                                                        const nets::SequenceShape& shape,
                                                        std::int64_t dilation) {
  const nets::DilatedTaps taps{.kernel = TemporalCoder::kernel, .dilation = dilation};
  const auto convolution = [&](const std::string& own) {
    return std::make_unique<nets::DilatedConvolution<T>>(parameters, name + own, shape.length,
                                                         taps);
  };
  return std::make_unique<nets::SequenceChain<T>>(
      nets::layers<T>(convolution("/conv0"), std::make_unique<nets::Relu<T>>(shape),
                      convolution("/conv1"), std::make_unique<nets::Relu<T>>(shape)));
}

template <class T>
void add_temporal_blocks(Layers<T>& layers, GradientArray<T>& parameters,
                         const nets::SequenceShape& shape, std::int64_t blocks) {
  for (std::int64_t i = 0; i < blocks; ++i) {
    layers.push_back(std::make_unique<nets::Residual<T>>(
        temporal_branch(parameters, block_name(i), shape, TemporalCoder::dilation(i))));
    layers.push_back(std::make_unique<nets::Relu<T>>(shape));
  }
}

}  // namespace

TemporalCoder::TemporalCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape),
      blocks_(options.depth - 1),
      positions_(frames_of(shape.samples, frame, "convolved")) {
  if (blocks_ < 1 || blocks_ > most_blocks) {
    throw Error(
        Exit::usage,
        fmt::format("--depth: {} is not possible: the coder has one dense layer and 1 to {} "
                    "blocks of convolutions; use 2 to {}",
                    options.depth, most_blocks, most_blocks + 1));
  }
}

std::int64_t TemporalCoder::dilation(std::int64_t block) {
  std::int64_t dilation = 1;
  for (std::int64_t i = 0; i < block; ++i) dilation *= growth;
  return dilation;
}

std::vector<nets::ParameterSpec> TemporalCoder::specs() const {
  std::vector<nets::ParameterSpec> specs;
  const auto add_blocks = [&](const std::string& network) {
    for (std::int64_t i = 0; i < blocks_; ++i) {
      for (const char* const convolution : {"/conv0", "/conv1"}) {
        append(specs, nets::dilated_convolution_specs(network + "/" + block_name(i) + convolution,
                                                      channels, channels, kernel));
      }
    }
  };
  append(specs, nets::dense_specs(encoder_name + "/frames", frame, channels));
  add_blocks(encoder_name);
  append(specs, nets::dense_specs(encoder_name + "/dense", channels, 2));
  append(specs,
         nets::dense_specs(decoder_name + "/dense", 2 + shape_.classes, positions_ * channels));
  add_blocks(decoder_name);
  append(specs, nets::dense_specs(decoder_name + "/frames", channels, frame));
  return specs;
}

template <class T>
Layers<T> TemporalCoder::encoder_layers(GradientArray<T>& parameters) const {
  const nets::SequenceShape shape{.length = positions_, .width = channels};
  auto layers =
      nets::layers<T>(std::make_unique<nets::PositionDense<T>>(parameters, "frames", positions_));
  add_temporal_blocks<T>(layers, parameters, shape, blocks_);
  layers.push_back(std::make_unique<nets::PositionMean<T>>(shape));
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1));
  return layers;
}

template <class T>
Layers<T> TemporalCoder::decoder_layers(GradientArray<T>& parameters) const {
  const nets::SequenceShape shape{.length = positions_, .width = channels};
  auto layers = nets::layers<T>(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1));
  add_temporal_blocks<T>(layers, parameters, shape, blocks_);
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "frames", positions_));
  return layers;
}

PIAE_INSTANTIATE_SEQUENCE_CODER(TemporalCoder);

}  // namespace piae::twin
