#include "libtorch/twin/recurrent_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <tuple>

#include "base/error.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/torch.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {

namespace {

using twin::decoder_name;
using twin::encoder_name;
using Specs = std::vector<nets::ParameterSpec>;

/// The parameters of a recurrent layer, in the order in which LibTorch's gru takes them. Each holds
/// those of the three gates, one below the other.
Specs gru_specs(const std::string& name, std::int64_t inputs, std::int64_t units) {
  const double bound = 1 / std::sqrt(static_cast<double>(units));
  return {{name + "/input_weight", {3 * units, inputs}, bound},
          {name + "/state_weight", {3 * units, units}, bound},
          {name + "/input_bias", {3 * units}, bound},
          {name + "/state_bias", {3 * units}, bound}};
}

}  // namespace

RecurrentCoder::RecurrentCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options)
    : shape_(shape), layers_(options.depth - 1) {
  if (layers_ < 1) {
    throw Error(Exit::usage,
                "--depth: 1 leaves no recurrent layer, since the last one is dense; 2 or more "
                "layers work");
  }
  if (shape.samples % frame != 0) {
    throw Error(Exit::usage, fmt::format("windows of {} samples are no whole number of the frames "
                                         "of {} that are read in turn; multiples of {} samples "
                                         "work (split --window)",
                                         shape.samples, frame, frame));
  }
}

std::vector<nets::ParameterSpec> RecurrentCoder::specs() const {
  Specs specs;
  const auto add = [&](const std::string& name, std::int64_t inputs, std::int64_t outputs) {
    for (std::int64_t i = 0; i < layers_; ++i) {
      append(specs, gru_specs(fmt::format("{}/gru{}", name, i), i == 0 ? inputs : units, units));
    }
    append(specs, nets::dense_specs(name + "/dense", units, outputs));
  };
  add(encoder_name, frame, 2);
  add(decoder_name, 2 + shape_.classes, frame);
  return specs;
}

torch::Tensor RecurrentCoder::run_gru(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x) const {
  const torch::Tensor at_rest = torch::zeros({layers_, x.size(0), units}, x.options());
  return std::get<0>(torch::gru(x, at_rest, parameters.with_prefix(name + "/gru"),
                                /*has_biases=*/true, layers_, /*dropout=*/0, /*train=*/true,
                                /*bidirectional=*/false, /*batch_first=*/true));
}

torch::Tensor RecurrentCoder::encode(const ParameterSet& parameters,
                                     const torch::Tensor& windows) const {
  const torch::Tensor frames = windows.view({windows.size(0), -1, frame});
  return run_dense(parameters, encoder_name + "/dense",
                   run_gru(parameters, encoder_name, frames).select(1, -1));
}

torch::Tensor RecurrentCoder::decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const {
  const torch::Tensor each_frame = input.unsqueeze(1).expand({-1, shape_.samples / frame, -1});
  return run_dense(parameters, decoder_name + "/dense",
                   run_gru(parameters, decoder_name, each_frame))
      .flatten(1);
}

}  // namespace piae::libtorch
