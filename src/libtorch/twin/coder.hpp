#pragma once

#include <torch/types.h>

#include <vector>

#include "libtorch/nets/parameters.hpp"
#include "twin/network_shape.hpp"

namespace piae::libtorch {

/// The layers of encoder and decoder, which the ablations of paper 4.5.4 replace. Their parameters
/// are net/encoder/... and net/decoder/... of a ParameterSet.
class Coder {
 public:
  virtual ~Coder() = default;

  [[nodiscard]] virtual std::vector<nets::ParameterSpec> specs() const = 0;

  /// Windows [batch, N] -> [batch, 2]; the caller makes them positive, by softplus or exp.
  [[nodiscard]] virtual torch::Tensor encode(const ParameterSet& parameters,
                                             const torch::Tensor& x) const = 0;

  /// (k~, c~, one-hot label) [batch, 2 + classes] -> acceleration [batch, N].
  [[nodiscard]] virtual torch::Tensor decode(const ParameterSet& parameters,
                                             const torch::Tensor& input) const = 0;
};

}  // namespace piae::libtorch
