#pragma once

#include <torch/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "nets/parameters.hpp"

namespace piae::nets {

/// Size of a chain of dense layers with ReLU between them.
struct DenseSize {
  int depth = 0;  ///< layers, at least 1
  int width = 0;  ///< units of a hidden layer
};

/// Parameters of a chain from `inputs` to `outputs` numbers: <name>/0/weight, <name>/0/bias, ...
std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size);

/// The chain of that name applied to x, [batch, inputs] -> [batch, outputs]. No ReLU at the end.
torch::Tensor run_dense_chain(const ParameterSet& parameters, const std::string& name,
                              torch::Tensor x);

}  // namespace piae::nets
