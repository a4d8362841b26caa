#pragma once

#include <torch/types.h>

#include <cstdint>
#include <string>

#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// Runs the dilated convolution of that name on [batch, channels, positions], with zeros beyond
/// both ends. Its parameters are those of nets::dilated_convolution_specs().
torch::Tensor run_dilated_convolution(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x, std::int64_t dilation);

}  // namespace piae::libtorch
