#pragma once

#include <torch/types.h>

#include <string>

#include "nets/parameters.hpp"

namespace piae::nets {

/// The chain of that name applied to x, [batch, inputs] -> [batch, outputs]. No ReLU at the end.
torch::Tensor run_dense_chain(const ParameterSet& parameters, const std::string& name,
                              torch::Tensor x);

}  // namespace piae::nets
