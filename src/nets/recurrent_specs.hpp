#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nets/parameter_spec.hpp"

namespace piae::nets {

/// The parameters of a layer of gated recurrent units: <name>/input_weight [3 units, inputs],
/// state_weight [3 units, units], input_bias and state_bias [3 units], in the order in which
/// LibTorch's gru takes them. Each holds those of the gates r, z and n (gru_gates.hpp), one below
/// the other.
std::vector<ParameterSpec> gru_specs(const std::string& name, std::int64_t inputs,
                                     std::int64_t units);

/// The size of a chain of recurrent layers.
struct RecurrentSize {
  std::int64_t layers = 0;
  std::int64_t units = 0;  ///< of each
};

/// The parameters <name>/gru0/..., <name>/gru1/..., ..., and <name>/dense/... of the dense layer
/// that makes `outputs` numbers of the last one's state.
std::vector<ParameterSpec> recurrent_chain_specs(const std::string& name, std::int64_t inputs,
                                                 std::int64_t outputs, RecurrentSize size);

}  // namespace piae::nets
