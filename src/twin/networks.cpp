#include "twin/networks.hpp"

#include <torch/torch.h>

#include <string>

namespace piae::twin {

namespace {

void add_chain(std::vector<nets::ParameterSpec>& specs, const std::string& name,
               std::int64_t inputs, std::int64_t outputs, const TwinOptions& options) {
  for (int layer = 0; layer < options.depth; ++layer) {
    const bool last = layer + 1 == options.depth;
    const std::int64_t units = last ? outputs : options.width;
    const auto dense = nets::dense_specs(name + "/" + std::to_string(layer), inputs, units);
    specs.insert(specs.end(), dense.begin(), dense.end());
    inputs = units;
  }
}

torch::Tensor run_chain(const nets::ParameterSet& parameters, const std::string& name,
                        torch::Tensor x) {
  const std::vector<torch::Tensor> tensors = parameters.with_prefix(name + "/");
  for (std::size_t i = 0; i < tensors.size(); i += 2) {
    if (i > 0) x = torch::relu(x);
    x = torch::linear(x, tensors[i], tensors[i + 1]);
  }
  return x;
}

/// Times of the samples, from 0 to 1 over the window, one row a window.
torch::Tensor times_like(const torch::Tensor& acceleration) {
  return torch::linspace(0, 1, acceleration.size(1), acceleration.options())
      .expand({acceleration.size(0), -1});
}

}  // namespace

std::vector<nets::ParameterSpec> network_specs(const NetworkShape& shape,
                                               const TwinOptions& options) {
  std::vector<nets::ParameterSpec> specs;
  add_chain(specs, "net/encoder", shape.samples, 2, options);
  add_chain(specs, "net/decoder", 2 + shape.classes, shape.samples, options);
  add_chain(specs, "net/physics", 2 * shape.samples, 2 * shape.samples, options);
  return specs;
}

torch::Tensor encode(const nets::ParameterSet& parameters, const torch::Tensor& x) {
  return torch::softplus(run_chain(parameters, "net/encoder", x));
}

torch::Tensor decode(const nets::ParameterSet& parameters, const torch::Tensor& k_and_c,
                     const torch::Tensor& label) {
  return run_chain(parameters, "net/decoder", torch::cat({k_and_c, label}, 1));
}

Motion move(const nets::ParameterSet& parameters, const torch::Tensor& acceleration) {
  const torch::Tensor input = torch::cat({acceleration, times_like(acceleration)}, 1);
  const std::vector<torch::Tensor> halves = run_chain(parameters, "net/physics", input).chunk(2, 1);
  return {halves[0], halves[1]};
}

}  // namespace piae::twin
