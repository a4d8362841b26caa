#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/label.hpp"
#include "nets/network.hpp"
#include "nets/parameters.hpp"
#include "twin/coder.hpp"
#include "twin/losses.hpp"
#include "twin/network_shape.hpp"
#include "twin/space.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

/// Encoder, decoder and physics-informed module for one core. Networks that a variant does not have
/// are null. The module is a chain of dense layers in every variant.
struct Networks {
  /// Makes networks for batches of up to `most_windows` windows. Decoder and module have room for
  /// two signals of such a batch (nets::Network::backward).
  Networks(const std::shared_ptr<nets::Parameters<float>>& parameters, const TwinVariant& variant,
           const Coder& coder, const NetworkShape& shape, Positive positive,
           std::int64_t most_windows);

  /// Eq. 16: windows [batch, N] -> (k~, c~), [batch, 2].
  RowArray<float> encode(const RowArray<float>& windows);
  /// Eq. 17: (k~, c~) [batch, 2] and labels [batch] -> acceleration [batch, N].
  RowArray<float> decode(const RowArray<float>& inputs, std::span<const Label> labels);
  /// Eq. 18: acceleration [batch, N] -> displacement and velocity, [batch, N] each.
  BatchMotion<float> move(const RowArray<float>& acceleration);

  NetworkShape shape;
  Positive positive;
  std::unique_ptr<nets::Network<float>> encoder;
  std::unique_ptr<nets::Network<float>> decoder;
  std::unique_ptr<nets::Network<float>> module;
};

/// Returns the slope of the function that makes (k~, c~) positive (eq. 16), from its output values.
RowArray<float> slope_at(const RowArray<float>& k_and_c, Positive positive);

/// Converts points to an array [n, 2], and back.
RowArray<float> as_rows(std::span<const TwinPoint> points);
std::vector<TwinPoint> as_points(const RowArray<float>& rows);

/// Eq. 16 for any number of windows [n, N], encoded `batch` at a time.
std::vector<TwinPoint> encode_all(Networks& networks, std::span<const float> windows,
                                  std::int64_t batch);

}  // namespace piae::twin
