#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "nets/dense_chain.hpp"
#include "nets/flat_parameters.hpp"
#include "twin/native_losses.hpp"
#include "twin/network_shape.hpp"
#include "twin/space.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

/// Encoder, decoder and physics-informed module (networks.hpp) as chains for one core. Those that a
/// variant does not have are null.
template <class T>
struct NativeNetworks {
  /// For batches of up to `most_windows`, and twice as many gradients.
  NativeNetworks(nets::FlatParameters<T>& parameters, const TwinVariant& variant,
                 const NetworkShape& shape, std::int64_t most_windows);

  /// Eq. 16: windows [batch, N] -> (k~, c~), [batch, 2].
  RowArray<T> encode(const RowArray<T>& windows);
  /// Eq. 17: acceleration [batch, N]; inputs are [batch, 2].
  RowArray<T> decode(const RowArray<T>& inputs, std::span<const std::int32_t> labels);
  /// Eq. 18.
  BatchMotion<T> move(const RowArray<T>& acceleration);

  NetworkShape shape;
  std::unique_ptr<nets::DenseChain<T>> encoder;
  std::unique_ptr<nets::DenseChain<T>> decoder;
  std::unique_ptr<nets::DenseChain<T>> module;
};

/// As [n, 2], and back.
template <class T>
RowArray<T> as_rows(std::span<const TwinPoint> points);
template <class T>
std::vector<TwinPoint> as_points(const RowArray<T>& rows);

/// Eq. 16 for any number of windows [n, N], `batch` at a time.
std::vector<TwinPoint> encode_all(NativeNetworks<float>& networks, std::span<const float> windows,
                                  std::int64_t batch);

extern template struct NativeNetworks<float>;
extern template struct NativeNetworks<double>;

}  // namespace piae::twin
