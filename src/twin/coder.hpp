#pragma once

#include <torch/types.h>

#include <cstdint>
#include <vector>

#include "nets/parameters.hpp"

namespace piae::twin {

/// Sizes that the networks share.
struct NetworkShape {
  std::int64_t samples = 0;  ///< of a window, N
  std::int64_t classes = 0;  ///< of the dataset; the label enters as a one-hot vector
};

/// The layers of encoder and decoder, which the ablations of paper 4.5.4 exchange. Their parameters
/// stand in a ParameterSet, as net/encoder/... and net/decoder/...
class Coder {
 public:
  virtual ~Coder() = default;

  [[nodiscard]] virtual std::vector<nets::ParameterSpec> specs() const = 0;

  /// Windows [batch, N] -> [batch, 2], of either sign.
  [[nodiscard]] virtual torch::Tensor encode(const nets::ParameterSet& parameters,
                                             const torch::Tensor& x) const = 0;

  /// (k~, c~, one-hot label) [batch, 2 + classes] -> acceleration [batch, N].
  [[nodiscard]] virtual torch::Tensor decode(const nets::ParameterSet& parameters,
                                             const torch::Tensor& input) const = 0;
};

}  // namespace piae::twin
