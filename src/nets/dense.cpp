#include "nets/dense.hpp"

#include "nets/torch.hpp"

namespace piae::nets {

std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size) {
  std::vector<ParameterSpec> specs;
  for (int layer = 0; layer < size.depth; ++layer) {
    const bool last = layer + 1 == size.depth;
    const std::int64_t units = last ? outputs : size.width;
    const auto dense = dense_specs(name + "/" + std::to_string(layer), inputs, units);
    specs.insert(specs.end(), dense.begin(), dense.end());
    inputs = units;
  }
  return specs;
}

torch::Tensor run_dense_chain(const ParameterSet& parameters, const std::string& name,
                              torch::Tensor x) {
  const std::vector<torch::Tensor> tensors = parameters.with_prefix(name + "/");
  for (std::size_t i = 0; i < tensors.size(); i += 2) {
    if (i > 0) x = torch::relu(x);
    x = torch::linear(x, tensors[i], tensors[i + 1]);
  }
  return x;
}

}  // namespace piae::nets
