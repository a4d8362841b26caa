#pragma once

#include <torch/types.h>

#include <memory>
#include <vector>

#include "nets/parameters.hpp"
#include "twin/coder.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// Displacement and velocity, dimensionless (twin/physics.hpp).
struct Motion {
  torch::Tensor displacement;  ///< u, [batch, N]
  torch::Tensor velocity;      ///< v, [batch, N]
};

/// Encoder, decoder and physics-informed module as functions of their parameters.
class Networks {
 public:
  /// Throws Error(usage) for a length of window or a depth that the variant's coder cannot have.
  Networks(const TwinVariant& variant, const NetworkShape& shape, const TwinOptions& options);

  /// net/encoder/..., net/decoder/... and, where the variant has it, net/physics/...
  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const;

  /// Eq. 16, (k~, c~) = Encoder(x): [batch, N] -> [batch, 2], positive by softplus.
  [[nodiscard]] torch::Tensor encode(const nets::ParameterSet& parameters,
                                     const torch::Tensor& x) const;

  /// Eq. 17, a = Decoder(k~, c~, label): [batch, 2], one-hot [batch, classes] -> acceleration
  /// [batch, N], in units of the class's a_ref.
  [[nodiscard]] torch::Tensor decode(const nets::ParameterSet& parameters,
                                     const torch::Tensor& k_and_c,
                                     const torch::Tensor& label) const;

  /// Eq. 18, (u, v) = PIM(a, t): decoded acceleration [batch, N] and the time of its samples ->
  /// motion. A chain of dense layers with ReLU between.
  [[nodiscard]] Motion move(const nets::ParameterSet& parameters,
                            const torch::Tensor& acceleration) const;

 private:
  TwinVariant variant_;
  NetworkShape shape_;
  TwinOptions options_;
  std::unique_ptr<Coder> coder_;
};

}  // namespace piae::twin
