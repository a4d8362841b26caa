#pragma once

#include <string>
#include <vector>

#include "nets/parameter_spec.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// The names of the parameters of each network begin with these, followed by a slash.
inline const std::string encoder_name = "net/encoder";
inline const std::string decoder_name = "net/decoder";
inline const std::string module_name = "net/physics";
/// ln alpha, ln beta and ln gamma of eq. 23.
inline const std::string log_weights_name = "loss/log_weights";

/// The parameters of all networks that the variant has. `coder` holds those of encoder and decoder
/// (coder.hpp).
/// The module of eq. 18, acceleration and times [2 N] -> displacement and velocity [2 N], is a
/// chain of dense layers in every variant.
std::vector<nets::ParameterSpec> network_specs(const TwinVariant& variant,
                                               const NetworkShape& shape,
                                               const TwinOptions& options,
                                               std::vector<nets::ParameterSpec> coder);

/// The same with the weights of the losses behind them: alpha = beta = gamma = 1 at the start.
std::vector<nets::ParameterSpec> with_log_weights(std::vector<nets::ParameterSpec> networks);

}  // namespace piae::twin
