#include "twin/transformer_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "nets/dot_product_attention.hpp"
#include "nets/layer_normalisation.hpp"
#include "nets/position_copy.hpp"
#include "nets/position_dense.hpp"
#include "nets/position_mean.hpp"
#include "nets/position_table.hpp"
#include "nets/relu.hpp"
#include "nets/residual.hpp"

namespace piae::twin {

namespace {

using nets::GradientArray;

constexpr std::int64_t width = TransformerCoder::width;
constexpr std::int64_t inner_width = TransformerCoder::inner_width;

std::vector<nets::ParameterSpec> transformer_block_specs(const std::string& name) {
  auto specs = nets::layer_normalisation_specs(name + "/attention/norm", width);
  append(specs, {nets::unbiased_dense_spec(name + "/attention/projections", width, 3 * width),
                 nets::unbiased_dense_spec(name + "/attention/output", width, width)});
  append(specs, nets::layer_normalisation_specs(name + "/dense/norm", width));
  append(specs, nets::dense_specs(name + "/dense/inner", width, inner_width));
  append(specs, nets::dense_specs(name + "/dense/output", inner_width, width));
  return specs;
}

template <class T>
std::unique_ptr<nets::SequenceLayer<T>> attention_branch(GradientArray<T>& parameters,
                                                         const std::string& name,
                                                         std::int64_t tokens) {
  const auto dense = [&](const char* own) {
    return std::make_unique<nets::PositionDense<T>>(parameters, name + own, tokens,
                                                    nets::Bias::absent);
  };
  return std::make_unique<nets::SequenceChain<T>>(nets::layers<T>(
      std::make_unique<nets::LayerNormalisation<T>>(parameters, name + "/norm", tokens),
      dense("/projections"),
      std::make_unique<nets::DotProductAttention<T>>(
          nets::SequenceShape{.length = tokens, .width = width}, TransformerCoder::heads),
      dense("/output")));
}

template <class T>
std::unique_ptr<nets::SequenceLayer<T>> dense_branch(GradientArray<T>& parameters,
                                                     const std::string& name, std::int64_t tokens) {
  const auto dense = [&](const char* own) {
    return std::make_unique<nets::PositionDense<T>>(parameters, name + own, tokens);
  };
  return std::make_unique<nets::SequenceChain<T>>(nets::layers<T>(
      std::make_unique<nets::LayerNormalisation<T>>(parameters, name + "/norm", tokens),
      dense("/inner"),
      std::make_unique<nets::Relu<T>>(nets::SequenceShape{.length = tokens, .width = inner_width}),
      dense("/output")));
}

/// Adds the positions, the blocks, and the final normalisation.
template <class T>
void add_transformer_blocks(Layers<T>& layers, GradientArray<T>& parameters, std::int64_t tokens,
                            std::int64_t blocks) {
  layers.push_back(std::make_unique<nets::PositionTable<T>>(parameters, "positions"));
  for (std::int64_t i = 0; i < blocks; ++i) {
    const std::string name = fmt::format("block{}", i);
    layers.push_back(std::make_unique<nets::Residual<T>>(
        attention_branch(parameters, name + "/attention", tokens)));
    layers.push_back(
        std::make_unique<nets::Residual<T>>(dense_branch(parameters, name + "/dense", tokens)));
  }
  layers.push_back(std::make_unique<nets::LayerNormalisation<T>>(parameters, "norm", tokens));
}

}  // namespace

TransformerCoder::TransformerCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape),
      blocks_(layers_except_dense(options.depth, "block of attention")),
      tokens_(frames_of(shape.samples, frame, "read as tokens")) {
  if (tokens_ > most_tokens) {
    throw Error(Exit::usage,
                fmt::format("windows of {} samples are too long for attention, whose memory grows "
                            "with the square of their length; use at most {} samples (split "
                            "--window)",
                            shape.samples, most_tokens * frame));
  }
}

std::vector<nets::ParameterSpec> TransformerCoder::specs() const {
  std::vector<nets::ParameterSpec> specs;
  const auto add_tokens = [&](const std::string& network) {
    append(specs,
           nets::position_table_specs(network + "/positions", {.length = tokens_, .width = width}));
    for (std::int64_t i = 0; i < blocks_; ++i) {
      append(specs, transformer_block_specs(fmt::format("{}/block{}", network, i)));
    }
    append(specs, nets::layer_normalisation_specs(network + "/norm", width));
  };
  append(specs, nets::dense_specs(encoder_name + "/frames", frame, width));
  add_tokens(encoder_name);
  append(specs, nets::dense_specs(encoder_name + "/dense", width, 2));
  append(specs, nets::dense_specs(decoder_name + "/dense", 2 + shape_.classes, width));
  add_tokens(decoder_name);
  append(specs, nets::dense_specs(decoder_name + "/frames", width, frame));
  return specs;
}

template <class T>
Layers<T> TransformerCoder::encoder_layers(GradientArray<T>& parameters) const {
  auto layers =
      nets::layers<T>(std::make_unique<nets::PositionDense<T>>(parameters, "frames", tokens_));
  add_transformer_blocks<T>(layers, parameters, tokens_, blocks_);
  layers.push_back(std::make_unique<nets::PositionMean<T>>(
      nets::SequenceShape{.length = tokens_, .width = width}));
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1));
  return layers;
}

template <class T>
Layers<T> TransformerCoder::decoder_layers(GradientArray<T>& parameters) const {
  auto layers = nets::layers<T>(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1),
                                std::make_unique<nets::PositionCopy<T>>(
                                    nets::SequenceShape{.length = tokens_, .width = width}));
  add_transformer_blocks<T>(layers, parameters, tokens_, blocks_);
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "frames", tokens_));
  return layers;
}

PIAE_INSTANTIATE_SEQUENCE_CODER(TransformerCoder);

}  // namespace piae::twin
