#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace piae::nets {

/// One parameter tensor of a network: its name, its shape, and how it starts. It starts uniform in
/// [-bound, bound], or with `constant` everywhere where bound is 0. The default of LibTorch for
/// dense, convolutional and recurrent layers, weights and biases alike, is bound = 1 / sqrt(inputs
/// of one unit); we use the same.
struct ParameterSpec {
  std::string name;  ///< "encoder/0/weight"
  std::vector<std::int64_t> shape;
  double bound = 0;
  double constant = 0;

  [[nodiscard]] std::int64_t size() const;
};

/// <name>/weight [outputs, inputs] and <name>/bias [outputs] of a dense layer.
std::vector<ParameterSpec> dense_specs(const std::string& name, std::int64_t inputs,
                                       std::int64_t outputs);

/// The size of a chain of dense layers with ReLU between them.
struct DenseSize {
  int depth = 0;  ///< layers, at least 1
  int width = 0;  ///< units of a hidden layer
};

/// The parameters <name>/0/weight, <name>/0/bias, <name>/1/weight, ... of a chain that turns
/// `inputs` numbers into `outputs` numbers.
std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size);

/// Appends `more` to `specs`.
void append(std::vector<ParameterSpec>& specs, const std::vector<ParameterSpec>& more);

/// How many numbers all these parameters hold together.
std::size_t total_size(const std::vector<ParameterSpec>& specs);

/// The values that a parameter starts with, in the order of its shape. They are drawn from the
/// child of the stream that has the parameter's name, so they do not depend on what else the model
/// holds.
std::vector<double> initial_values(const ParameterSpec& spec, const Stream& stream);

}  // namespace piae::nets
