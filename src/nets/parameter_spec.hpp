#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace piae::nets {

/// One parameter tensor of a network, and how it starts: uniform in [-bound, bound], or `constant`
/// where bound is 0. LibTorch's own default for dense, convolutional and recurrent layers is
/// bound = 1 / sqrt(inputs of one unit), for weights and biases alike.
struct ParameterSpec {
  std::string name;  ///< "encoder/0/weight"
  std::vector<std::int64_t> shape;
  double bound = 0;
  double constant = 0;

  [[nodiscard]] std::int64_t size() const;
};

/// Weight [outputs, inputs] and bias [outputs] of a dense layer called "<name>".
std::vector<ParameterSpec> dense_specs(const std::string& name, std::int64_t inputs,
                                       std::int64_t outputs);

/// Size of a chain of dense layers with ReLU between them.
struct DenseSize {
  int depth = 0;  ///< layers, at least 1
  int width = 0;  ///< units of a hidden layer
};

/// Parameters of a chain from `inputs` to `outputs` numbers: <name>/0/weight, <name>/0/bias, ...
std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size);

/// Numbers in all of them.
std::size_t total_size(const std::vector<ParameterSpec>& specs);

/// The values that it starts with, in the order of its shape. They come from the stream's child of
/// its name, so that they do not depend on what else the model holds.
std::vector<double> initial_values(const ParameterSpec& spec, const Stream& stream);

}  // namespace piae::nets
