#include "libtorch/twin/transformer_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "nets/layer_normalisation.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

using twin::decoder_name;
using twin::encoder_name;
using Sizes = twin::TransformerCoder;

torch::Tensor run_normalisation(const ParameterSet& parameters, const std::string& name,
                                const torch::Tensor& x) {
  return torch::layer_norm(x, {x.size(-1)}, parameters[name + "/scale"],
                           parameters[name + "/shift"], nets::LayerNormalisation<float>::epsilon);
}

/// [batch, tokens, width] -> same shape.
torch::Tensor run_attention(const ParameterSet& parameters, const std::string& name,
                            const torch::Tensor& x) {
  const torch::Tensor parts = torch::linear(x, parameters[name + "/projections/weight"])
                                  .view({x.size(0), x.size(1), 3, Sizes::heads, -1})
                                  .permute({2, 0, 3, 1, 4});  // [3, batch, heads, tokens, head]
  const double factor = 1 / std::sqrt(static_cast<double>(parts.size(-1)));
  const torch::Tensor scores = torch::matmul(parts[0], parts[1].transpose(-2, -1)) * factor;
  const torch::Tensor heads = torch::matmul(torch::softmax(scores, -1), parts[2]);
  return torch::linear(heads.transpose(1, 2).flatten(2), parameters[name + "/output/weight"]);
}

}  // namespace

torch::Tensor TransformerCoder::run_blocks(const ParameterSet& parameters,
                                           const std::string& network, torch::Tensor x) const {
  x = x + parameters[network + "/positions"];
  for (std::int64_t i = 0; i < layers_.blocks(); ++i) {
    const std::string attention = fmt::format("{}/block{}/attention", network, i);
    x = x +
        run_attention(parameters, attention, run_normalisation(parameters, attention + "/norm", x));
    const std::string dense = fmt::format("{}/block{}/dense", network, i);
    const torch::Tensor inner =
        run_dense(parameters, dense + "/inner", run_normalisation(parameters, dense + "/norm", x));
    x = x + run_dense(parameters, dense + "/output", torch::relu(inner));
  }
  return run_normalisation(parameters, network + "/norm", x);
}

torch::Tensor TransformerCoder::encode(const ParameterSet& parameters,
                                       const torch::Tensor& windows) const {
  const torch::Tensor frames = windows.view({windows.size(0), tokens_, Sizes::frame});
  const torch::Tensor x = run_dense(parameters, encoder_name + "/frames", frames);
  return run_dense(parameters, encoder_name + "/dense",
                   run_blocks(parameters, encoder_name, x).mean(1));
}

torch::Tensor TransformerCoder::decode(const ParameterSet& parameters,
                                       const torch::Tensor& input) const {
  const torch::Tensor x =
      run_dense(parameters, decoder_name + "/dense", input).unsqueeze(1).expand({-1, tokens_, -1});
  return run_dense(parameters, decoder_name + "/frames", run_blocks(parameters, decoder_name, x))
      .flatten(1);
}

}  // namespace piae::libtorch
