#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace piae::nets {

/// One parameter tensor of a network: its name, shape and initial values. These are uniform in
/// [-bound, bound], or all equal to `constant` if bound is 0. We use LibTorch's default for weights
/// and biases of dense, convolutional and recurrent layers: bound = 1 / sqrt(inputs of one unit).
struct ParameterSpec {
  std::string name;  ///< "encoder/0/weight"
  std::vector<std::int64_t> shape;
  double bound = 0;
  double constant = 0;

  [[nodiscard]] std::int64_t size() const;
};

/// Returns <name>/weight [outputs, inputs] and <name>/bias [outputs] of a dense layer.
std::vector<ParameterSpec> dense_specs(const std::string& name, std::int64_t inputs,
                                       std::int64_t outputs);

/// Size of a chain of dense layers with ReLU between them.
struct DenseSize {
  int depth = 0;  ///< layers, at least 1
  int width = 0;  ///< units of a hidden layer
};

/// Returns the parameters <name>/0/weight, <name>/0/bias, <name>/1/weight, ... of a chain that maps
/// `inputs` numbers to `outputs` numbers.
std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size);

/// Appends `more` to `specs`.
void append(std::vector<ParameterSpec>& specs, const std::vector<ParameterSpec>& more);

/// Returns the number of values in all these parameters.
std::size_t total_size(const std::vector<ParameterSpec>& specs);

/// Returns the initial values of a parameter, in the order of its shape. Draws them from the child
/// of the stream with the parameter's name, so they do not depend on other parameters of the model.
std::vector<double> initial_values(const ParameterSpec& spec, const Stream& stream);

}  // namespace piae::nets
