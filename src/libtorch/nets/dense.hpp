#pragma once

#include <torch/types.h>

#include <string>

#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// Runs the dense layer with the parameters <name>/weight and <name>/bias: [batch, inputs] ->
/// [batch, outputs].
torch::Tensor run_dense(const ParameterSet& parameters, const std::string& name,
                        const torch::Tensor& x);

/// Runs the chain of dense layers of that name, with ReLU between them but not at the end: [batch,
/// inputs] -> [batch, outputs]. Its parameters are those of nets::dense_chain_specs().
torch::Tensor run_dense_chain(const ParameterSet& parameters, const std::string& name,
                              torch::Tensor x);

}  // namespace piae::libtorch
