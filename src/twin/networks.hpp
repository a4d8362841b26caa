#pragma once

#include <torch/types.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "nets/parameters.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Sizes that the three networks share.
struct NetworkShape {
  std::int64_t samples = 0;  ///< of a window, N
  std::int64_t classes = 0;  ///< of the dataset; the label enters as a one-hot vector
};

/// Parameters of the encoder (eq. 16), decoder (eq. 17) and physics-informed module (eq. 18), named
/// net/encoder/..., net/decoder/..., net/physics/..., each a chain of dense layers with ReLU
/// between.
std::vector<nets::ParameterSpec> network_specs(const NetworkShape& shape,
                                               const TwinOptions& options);

/// (k~, c~) = Encoder(x): [batch, N] -> [batch, 2], positive by softplus.
torch::Tensor encode(const nets::ParameterSet& parameters, const torch::Tensor& x);

/// a = Decoder(k~, c~, label): [batch, 2], one-hot [batch, classes] -> acceleration [batch, N], in
/// units of the class's a_ref.
torch::Tensor decode(const nets::ParameterSet& parameters, const torch::Tensor& k_and_c,
                     const torch::Tensor& label);

/// Displacement and velocity, dimensionless (twin/physics.hpp).
struct Motion {
  torch::Tensor displacement;  ///< u, [batch, N]
  torch::Tensor velocity;      ///< v, [batch, N]
};

/// (u, v) = PIM(a, t): decoded acceleration [batch, N] and the time of its samples -> motion.
Motion move(const nets::ParameterSet& parameters, const torch::Tensor& acceleration);

}  // namespace piae::twin
