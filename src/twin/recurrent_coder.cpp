#include "twin/recurrent_coder.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "nets/recurrent_chain.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

RecurrentCoder::RecurrentCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape), size_{.layers = options.depth - 1, .units = units} {
  if (size_.layers < 1) {
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
  auto specs = nets::recurrent_chain_specs(encoder_name, frame, 2, size_);
  append(specs, nets::recurrent_chain_specs(decoder_name, 2 + shape_.classes, frame, size_));
  return specs;
}

std::unique_ptr<Coder::Network> RecurrentCoder::encoder(
    const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const {
  return std::make_unique<nets::RecurrentChain<float>>(
      parameters, encoder_name, nets::FrameCounts{.input = frames(), .output = 1}, most_rows);
}

std::unique_ptr<Coder::Network> RecurrentCoder::decoder(
    const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const {
  return std::make_unique<nets::RecurrentChain<float>>(
      parameters, decoder_name, nets::FrameCounts{.input = 1, .output = frames()}, most_rows);
}

}  // namespace piae::twin
