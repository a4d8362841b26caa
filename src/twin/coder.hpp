#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "nets/network.hpp"
#include "nets/parameter_spec.hpp"
#include "nets/parameters.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// The layers of encoder and decoder, which the ablations of paper 4.5.4 and those of its outlook
/// replace. Their parameters are net/encoder/... and net/decoder/... (specs.hpp).
class Coder {
 public:
  using Network = nets::Network<float>;
  using Parameters = nets::Parameters<float>;

  virtual ~Coder() = default;

  [[nodiscard]] virtual std::vector<nets::ParameterSpec> specs() const = 0;

  /// Returns the encoder: windows [batch, N] -> [batch, 2], for up to `most_rows` rows. The caller
  /// converts the output to (k~, c~) by softplus or exp.
  [[nodiscard]] virtual std::unique_ptr<Network> encoder(
      const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const = 0;

  /// Returns the decoder: (k~, c~, one-hot label) [batch, 2 + classes] -> acceleration [batch, N].
  [[nodiscard]] virtual std::unique_ptr<Network> decoder(
      const std::shared_ptr<Parameters>& parameters, std::int64_t most_rows) const = 0;
};

/// Throws Error(usage) if a coder of this kind does not support the window length or the depth.
std::unique_ptr<Coder> make_coder(CoderKind kind, const NetworkShape& shape,
                                  const TwinOptions& options);

}  // namespace piae::twin
