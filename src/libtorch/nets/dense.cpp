#include "libtorch/nets/dense.hpp"

#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

torch::Tensor run_dense(const ParameterSet& parameters, const std::string& name,
                        const torch::Tensor& x) {
  return torch::linear(x, parameters[name + "/weight"], parameters[name + "/bias"]);
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

}  // namespace piae::libtorch
