#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "twin/losses.hpp"
#include "twin/network_shape.hpp"
#include "twin/space.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

/// Encoder, decoder and physics-informed module (networks.hpp) as chains for one core. Those that a
/// variant does not have are null.
struct Networks {
  /// For batches of up to `most_windows`, and twice as many gradients.
  Networks(nets::Parameters<float>& parameters, const TwinVariant& variant,
                 const NetworkShape& shape, std::int64_t most_windows);

  /// Eq. 16: windows [batch, N] -> (k~, c~), [batch, 2].
  RowArray<float> encode(const RowArray<float>& windows);
  /// Eq. 17: acceleration [batch, N]; inputs are [batch, 2].
  RowArray<float> decode(const RowArray<float>& inputs, std::span<const std::int32_t> labels);
  /// Eq. 18.
  BatchMotion<float> move(const RowArray<float>& acceleration);

  NetworkShape shape;
  std::unique_ptr<nets::DenseChain<float>> encoder;
  std::unique_ptr<nets::DenseChain<float>> decoder;
  std::unique_ptr<nets::DenseChain<float>> module;
};

/// The slope of eq. 16's softplus where it gave these: 1 - exp(-k), to all digits of a small k.
RowArray<float> softplus_slope(const RowArray<float>& k_and_c);

/// As [n, 2], and back.
RowArray<float> as_rows(std::span<const TwinPoint> points);
std::vector<TwinPoint> as_points(const RowArray<float>& rows);

/// Eq. 16 for any number of windows [n, N], `batch` at a time.
std::vector<TwinPoint> encode_all(Networks& networks, std::span<const float> windows,
                                  std::int64_t batch);

}  // namespace piae::twin
