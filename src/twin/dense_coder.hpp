#pragma once

#include "twin/coder.hpp"

namespace piae::twin {

/// Encoder and decoder of PIAE-DT itself (eqs 16 and 17): chains of `depth` dense layers, `width`
/// wide, with ReLU between them, [N] -> [2] and [2 + classes] -> [N]. Windows may have any length.
class DenseCoder final : public Coder {
 public:
  DenseCoder(const NetworkShape& shape, const TwinOptions& options)
      : shape_(shape), size_{.depth = options.depth, .width = options.width} {}

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] std::unique_ptr<Network> encoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override;
  [[nodiscard]] std::unique_ptr<Network> decoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override;

 private:
  NetworkShape shape_;
  nets::DenseSize size_;
};

}  // namespace piae::twin
