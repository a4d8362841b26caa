#include "nets/parameter_spec.hpp"

#include <cmath>

namespace piae::nets {

std::int64_t ParameterSpec::size() const {
  std::int64_t size = 1;
  for (const std::int64_t n : shape) size *= n;
  return size;
}

std::vector<ParameterSpec> dense_specs(const std::string& name, std::int64_t inputs,
                                       std::int64_t outputs) {
  const double bound = 1.0 / std::sqrt(static_cast<double>(inputs));
  return {{name + "/weight", {outputs, inputs}, bound}, {name + "/bias", {outputs}, bound}};
}

std::vector<ParameterSpec> dense_chain_specs(const std::string& name, std::int64_t inputs,
                                             std::int64_t outputs, DenseSize size) {
  std::vector<ParameterSpec> specs;
  for (int layer = 0; layer < size.depth; ++layer) {
    const bool last = layer + 1 == size.depth;
    const std::int64_t units = last ? outputs : size.width;
    append(specs, dense_specs(name + "/" + std::to_string(layer), inputs, units));
    inputs = units;
  }
  return specs;
}

void append(std::vector<ParameterSpec>& specs, const std::vector<ParameterSpec>& more) {
  specs.insert(specs.end(), more.begin(), more.end());
}

std::size_t total_size(const std::vector<ParameterSpec>& specs) {
  std::size_t size = 0;
  for (const ParameterSpec& spec : specs) size += static_cast<std::size_t>(spec.size());
  return size;
}

std::vector<double> initial_values(const ParameterSpec& spec, const Stream& stream) {
  std::vector<double> values(static_cast<std::size_t>(spec.size()), spec.constant);
  if (spec.bound > 0) {
    Stream own = stream.child(spec.name);
    for (double& value : values) value = own.uniform(-spec.bound, spec.bound);
  }
  return values;
}

}  // namespace piae::nets
