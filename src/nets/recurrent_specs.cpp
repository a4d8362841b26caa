#include "nets/recurrent_specs.hpp"

#include <cmath>

namespace piae::nets {

std::vector<ParameterSpec> gru_specs(const std::string& name, std::int64_t inputs,
                                     std::int64_t units) {
  const double bound = 1 / std::sqrt(static_cast<double>(units));
  return {{name + "/input_weight", {3 * units, inputs}, bound},
          {name + "/state_weight", {3 * units, units}, bound},
          {name + "/input_bias", {3 * units}, bound},
          {name + "/state_bias", {3 * units}, bound}};
}

std::vector<ParameterSpec> recurrent_chain_specs(const std::string& name, std::int64_t inputs,
                                                 std::int64_t outputs, RecurrentSize size) {
  std::vector<ParameterSpec> specs;
  for (std::int64_t i = 0; i < size.layers; ++i) {
    append(specs,
           gru_specs(name + "/gru" + std::to_string(i), i == 0 ? inputs : size.units, size.units));
  }
  append(specs, dense_specs(name + "/dense", size.units, outputs));
  return specs;
}

}  // namespace piae::nets
