#include "twin/specs.hpp"

namespace piae::twin {

std::vector<nets::ParameterSpec> network_specs(const TwinVariant& variant,
                                               const NetworkShape& shape,
                                               const TwinOptions& options,
                                               std::vector<nets::ParameterSpec> coder) {
  if (!variant.encoder) {
    std::erase_if(coder, [](const auto& spec) { return spec.name.starts_with(encoder_name); });
  }
  if (variant.physics) {
    append(coder, nets::dense_chain_specs(module_name, 2 * shape.samples, 2 * shape.samples,
                                          {.depth = options.depth, .width = options.width}));
  }
  return coder;
}

std::vector<nets::ParameterSpec> with_log_weights(std::vector<nets::ParameterSpec> networks) {
  networks.push_back({.name = log_weights_name, .shape = {3}});
  return networks;
}

}  // namespace piae::twin
