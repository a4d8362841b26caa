#pragma once

#include <torch/types.h>

#include <string>

#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// The chain of that name applied to x, [batch, inputs] -> [batch, outputs]. No ReLU at the end.
torch::Tensor run_dense_chain(const ParameterSet& parameters, const std::string& name,
                              torch::Tensor x);

}  // namespace piae::libtorch
