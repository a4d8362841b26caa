#pragma once

// Networks of convolutions, small and of several strides. Tests of our kernels alone and those
// beside LibTorch share them.

#include <memory>
#include <string>
#include <vector>

#include "nets/convolutional_chain.hpp"
#include "nets/dense_chain.hpp"
#include "nets/joined_networks.hpp"
#include "nets/row_array.hpp"

namespace piae::nets {

/// What there is an example of: two convolutions, from 3 channels to 16 and 32, with strides 4 and
/// 2; two transposed ones, the other way; and both with a dense layer at their inner end, as in a
/// twin.
enum class Convolutions { strided, transposed, encoder, decoder };

struct ConvolutionExample {
  static constexpr std::int64_t length = 24;
  static constexpr std::int64_t channels = 3;
  static constexpr std::int64_t samples = length * channels;  ///< in a row, [time, channel]
  static constexpr std::int64_t inner_length = 3;
  static constexpr std::int64_t inner_channels = 32;
  static constexpr std::int64_t features = inner_length * inner_channels;
  static constexpr std::int64_t code = 5;

  explicit ConvolutionExample(Convolutions which) : which(which) {
    const std::vector<ParameterSpec> outer{{"net/conv0/weight", {16, 3, 8}, 0.3},
                                           {"net/conv0/bias", {is_encoding() ? 16 : 3}, 0.3}};
    const std::vector<ParameterSpec> inner{{"net/conv1/weight", {32, 16, 4}, 0.2},
                                           {"net/conv1/bias", {is_encoding() ? 32 : 16}, 0.2}};
    specs = is_encoding() ? outer : inner;
    append(specs, is_encoding() ? inner : outer);
    for (std::size_t i = 0; i < specs.size(); ++i) {
      specs[i].name[std::string("net/conv").size()] = i < 2 ? '0' : '1';
    }
    if (which == Convolutions::encoder) append(specs, dense_specs("net/dense", features, code));
    if (which == Convolutions::decoder) append(specs, dense_specs("net/dense", code, features));
  }

  [[nodiscard]] bool is_encoding() const {
    return which == Convolutions::strided || which == Convolutions::encoder;
  }
  [[nodiscard]] std::int64_t inputs() const {
    if (is_encoding()) return samples;
    return which == Convolutions::transposed ? features : code;
  }
  [[nodiscard]] std::int64_t outputs() const {
    if (!is_encoding()) return samples;
    return which == Convolutions::strided ? features : code;
  }

  template <class T>
  [[nodiscard]] std::unique_ptr<Network<T>> network(
      const std::shared_ptr<Parameters<T>>& parameters, std::int64_t most_rows) const {
    auto convolutions = std::make_unique<ConvolutionalChain<T>>(
        parameters, "net", is_encoding() ? ConvolutionKind::strided : ConvolutionKind::transposed,
        is_encoding() ? length : inner_length, most_rows);
    if (which == Convolutions::strided || which == Convolutions::transposed) return convolutions;
    auto dense = std::make_unique<DenseChain<T>>(parameters, "net/dense", most_rows);
    if (which == Convolutions::encoder) {
      return std::make_unique<JoinedNetworks<T>>(std::move(convolutions), inner_length,
                                                 inner_channels, std::move(dense));
    }
    return std::make_unique<JoinedNetworks<T>>(std::move(dense), inner_channels, inner_length,
                                               std::move(convolutions));
  }

  Convolutions which;
  std::vector<ParameterSpec> specs;
};

inline std::string name_of(Convolutions which) {
  switch (which) {
    case Convolutions::strided:
      return "Strided";
    case Convolutions::transposed:
      return "Transposed";
    case Convolutions::encoder:
      return "Encoder";
    case Convolutions::decoder:
      return "Decoder";
  }
  return "";
}

/// Numbers of a normal distribution.
inline RowArray<double> drawn(const std::string& name, std::int64_t rows, std::int64_t columns) {
  Stream stream(name);
  RowArray<double> array(rows, columns);
  for (double& x : array.reshaped<Eigen::RowMajor>()) x = stream.normal(0, 1);
  return array;
}

/// The parameters' own numbers of one of their three arrays, without what fills rows up, or what
/// fills them up alone.
template <class T>
std::vector<T> held(const Parameters<T>& parameters, typename Parameters<T>::Kept kept,
                    bool filling = false) {
  std::vector<T> all;
  for (const auto& p : parameters.parameters()) {
    for (std::int64_t i = 0; i < p.rows; ++i) {
      const T* const row = parameters.data(kept) + p.begin + i * p.held_columns;
      all.insert(all.end(), filling ? row + p.columns : row,
                 row + (filling ? p.held_columns : p.columns));
    }
  }
  return all;
}

}  // namespace piae::nets
