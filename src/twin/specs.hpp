#pragma once

#include <string>
#include <vector>

#include "nets/parameter_spec.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// Prefixes of the parameter names of each network; a slash follows.
inline const std::string encoder_name = "net/encoder";
inline const std::string decoder_name = "net/decoder";
inline const std::string module_name = "net/physics";
/// ln alpha, ln beta and ln gamma of eq. 23.
inline const std::string log_weights_name = "loss/log_weights";

/// Returns the parameters of all networks of the variant. `coder` holds those of encoder and
/// decoder (coder.hpp). The module of eq. 18, acceleration and times [2 N] -> displacement and
/// velocity [2 N], is a chain of dense layers in every variant.
std::vector<nets::ParameterSpec> network_specs(const TwinVariant& variant,
                                               const NetworkShape& shape,
                                               const TwinOptions& options,
                                               std::vector<nets::ParameterSpec> coder);

/// Appends the loss weights to these parameters. Initially alpha = beta = gamma = 1.
std::vector<nets::ParameterSpec> with_log_weights(std::vector<nets::ParameterSpec> networks);

}  // namespace piae::twin
