#pragma once

#include <torch/types.h>

#include <memory>
#include <vector>

#include "libtorch/nets/parameters.hpp"
#include "libtorch/twin/coder.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::libtorch {

/// Displacement and velocity, dimensionless (twin/physics.hpp).
struct Motion {
  torch::Tensor displacement;  ///< u, [batch, N]
  torch::Tensor velocity;      ///< v, [batch, N]
};

/// Encoder, decoder and physics-informed module as functions of their parameters.
class Networks {
 public:
  /// Throws Error(usage) if the variant's coder does not support the window length or the depth.
  Networks(const twin::TwinVariant& variant, const twin::NetworkShape& shape,
           const twin::TwinOptions& options);

  /// Returns the parameters of all networks of the variant (twin::network_specs).
  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const;

  /// Eq. 16, (k~, c~) = Encoder(x): [batch, N] -> [batch, 2], made positive by softplus or exp.
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters, const torch::Tensor& x) const;

  /// Eq. 17, a = Decoder(k~, c~, label): [batch, 2], one-hot [batch, classes] -> acceleration
  /// [batch, N], in units of the class's a_ref.
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters, const torch::Tensor& k_and_c,
                                     const torch::Tensor& label) const;

  /// Eq. 18, (u, v) = PIM(a, t): decoded acceleration [batch, N] and the times of its samples ->
  /// motion, by a chain of dense layers with ReLU between them.
  [[nodiscard]] Motion move(const ParameterSet& parameters,
                            const torch::Tensor& acceleration) const;

 private:
  twin::TwinVariant variant_;
  twin::NetworkShape shape_;
  twin::TwinOptions options_;
  std::unique_ptr<Coder> coder_;
};

}  // namespace piae::libtorch
