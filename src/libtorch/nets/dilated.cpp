#include "libtorch/nets/dilated.hpp"

#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

torch::Tensor run_dilated_convolution(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x, std::int64_t dilation) {
  // LibTorch's weight is [outputs, inputs, kernel].
  const torch::Tensor weight = parameters[name + "/weight"].transpose(1, 2);
  const std::int64_t padding = weight.size(2) / 2 * dilation;
  return torch::conv1d(x, weight, parameters[name + "/bias"], /*stride=*/1, padding, dilation);
}

}  // namespace piae::libtorch
