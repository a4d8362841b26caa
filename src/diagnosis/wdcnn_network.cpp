#include "diagnosis/wdcnn_network.hpp"

#include <algorithm>

#include "base/label.hpp"
#include "base/vector.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "diagnosis/wdcnn_weights.hpp"

namespace piae::diagnosis {

namespace {

/// The stride of the first convolution is also the number of samples that become the channels of
/// one time (time_convolution.hpp).
constexpr Convolution first = WdcnnLayers::convolutions.front();
constexpr std::int64_t first_channels = first.stride * first.inputs;
static_assert(first.width % first.stride == 0 && first_channels % row_granule == 0);

TimeConvolution first_convolution(std::int64_t length) {
  const std::int64_t taps = first.width / first.stride;
  return {.inputs = first_channels,
          .outputs = first.outputs,
          .width = taps,
          .padding = 0,
          .input_length = first.output_length(length) + taps - 1};
}

/// Returns all layers with batch normalisation, the convolutions and the dense layer, for windows
/// of `length` samples.
std::vector<TimeConvolution> normalised_layers(std::int64_t length) {
  std::vector<TimeConvolution> layers{first_convolution(length)};
  for (std::size_t i = 1; i < WdcnnLayers::convolutions.size(); ++i) {
    const Convolution& c = WdcnnLayers::convolutions[i];
    const std::int64_t input_length = layers.back().output_length() / WdcnnLayers::pooling;
    layers.push_back({.inputs = c.inputs,
                      .outputs = c.outputs,
                      .width = c.width,
                      .padding = c.padding,
                      .input_length = input_length});
  }
  const std::int64_t times = layers.back().output_length() / WdcnnLayers::pooling;
  layers.push_back({.inputs = layers.back().outputs,
                    .outputs = whole_rows(WdcnnLayers::hidden),
                    .width = times,
                    .padding = 0,
                    .input_length = times});
  return layers;
}

}  // namespace

template <class T>
WdcnnNetwork<T>::WdcnnNetwork(std::int64_t length, std::int64_t classes, std::int64_t most_windows,
                              const Stream& stream)
    : length_(length),
      number_of_classes_(classes),
      most_windows_(most_windows),
      layout_(wdcnn_layout(length, classes)),
      values_(Numbers::Zero(layout_.back().begin + layout_.back().held_size())),
      gradients_(Numbers::Zero(values_.size())) {
  for (const WdcnnParameter& parameter : layout_) {
    const std::vector<double> initial = nets::initial_values(parameter.spec, stream);
    parameter.for_each([&](std::int64_t i, std::int64_t j) {
      values_[j] = static_cast<T>(initial[static_cast<std::size_t>(i)]);
    });
  }
  make_layers();
  make_scratch();
}

template <class T>
std::int64_t WdcnnNetwork<T>::begin_of(const std::string& parameter) const {
  return std::ranges::find(layout_, parameter, [](const WdcnnParameter& p) { return p.spec.name; })
      ->begin;
}

template <class T>
typename WdcnnNetwork<T>::Layer WdcnnNetwork<T>::make_layer(const TimeConvolution& convolution,
                                                            const std::string& name) const {
  return {
      .convolution = convolution,
      .weight = begin_of(name + "/weight"),
      .input = Numbers::Zero(convolution.input_length * most_windows_ * convolution.inputs),
      .output = Numbers::Zero(convolution.output_length() * most_windows_ * convolution.outputs)};
}

template <class T>
void WdcnnNetwork<T>::make_layers() {
  const std::vector<TimeConvolution> convolutions = normalised_layers(length_);
  for (std::size_t i = 0; i < convolutions.size(); ++i) {
    const std::string name = layer_name(i);
    const Numbers zeros = Numbers::Zero(convolutions[i].outputs);
    // A class with a base cannot have designated initialisers.
    layers_.push_back({make_layer(convolutions[i], name),
                       /*pooling=*/name == "dense" ? 1 : WdcnnLayers::pooling,
                       /*scale=*/begin_of(name + "/scale"), /*shift=*/begin_of(name + "/shift"),
                       /*mean=*/zeros, /*inverse_deviation=*/zeros, /*running_mean=*/zeros,
                       /*running_variance=*/zeros + 1});
  }
  classes_ = make_layer({.inputs = convolutions.back().outputs,
                         .outputs = whole_rows(number_of_classes_),
                         .width = 1,
                         .padding = 0,
                         .input_length = 1},
                        "classes");
  bias_ = begin_of("classes/bias");
}

template <class T>
void WdcnnNetwork<T>::make_scratch() {
  Eigen::Index output = classes_.output.size();
  Eigen::Index pooled = classes_.input.size();
  std::int64_t weights = classes_.convolution.weights();
  for (const Layer& layer : layers_) {
    output = std::max(output, layer.output.size());
    pooled = std::max(pooled, layer.input.size());
    weights = std::max(weights, layer.convolution.weights());
  }
  output_gradient_ = Numbers::Zero(output);
  pooled_gradient_ = Numbers::Zero(pooled);
  transposed_ = Numbers::Zero(weights);
}

template <class T>
T* WdcnnNetwork<T>::input_after(std::size_t i) {
  return (i + 1 < layers_.size() ? layers_[i + 1].input : classes_.input).data();
}

template <class T>
PooledShape WdcnnNetwork<T>::pooled_shape(const NormalisedLayer& layer) const {
  return {.length = layer.convolution.output_length(),
          .windows = windows_,
          .channels = layer.convolution.outputs,
          .pooling = layer.pooling};
}

template <class T>
Normalisation<T> WdcnnNetwork<T>::normalisation(NormalisedLayer& layer) const {
  return {.scale = values_.data() + layer.scale,
          .shift = values_.data() + layer.shift,
          .running_mean = layer.running_mean.data(),
          .running_variance = layer.running_variance.data(),
          .mean = layer.mean.data(),
          .inverse_deviation = layer.inverse_deviation.data()};
}

/// Copies the windows into the first convolution's input, in its order and with its padding.
template <class T>
void WdcnnNetwork<T>::read(std::span<const float* const> windows) {
  windows_ = static_cast<std::int64_t>(windows.size());
  const std::int64_t times = layers_.front().convolution.input_length;
  for (std::int64_t i = 0; i < windows_; ++i) {
    const float* const window = windows[static_cast<std::size_t>(i)];
    for (std::int64_t t = 0; t < times; ++t) {
      T* const to = layers_.front().input.data() + (t * windows_ + i) * first_channels;
      const std::int64_t begin = t * first_channels - first.padding;
      if (begin >= 0 && begin + first_channels <= length_) {
        std::copy_n(window + begin, first_channels, to);
        continue;
      }
      for (std::int64_t c = 0; c < first_channels; ++c) {
        const std::int64_t at = begin + c;
        to[c] = at >= 0 && at < length_ ? static_cast<T>(window[at]) : T{0};
      }
    }
  }
}

template <class T>
const T* WdcnnNetwork<T>::forward(std::span<const float* const> windows, Mode mode) {
  read(windows);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    NormalisedLayer& layer = layers_[i];
    convolve<T>(layer.convolution, windows_, layer.input.data(), values_.data() + layer.weight,
                layer.output.data());
    const PooledShape shape = pooled_shape(layer);
    const Normalisation<T> n = normalisation(layer);
    if (mode == Mode::training) {
      use_batch_statistics<T>(shape, layer.output.data(), n);
    } else {
      use_running_statistics<T>(shape.channels, n);
    }
    normalise_and_pool<T>(shape, layer.output.data(), n, input_after(i));
  }
  convolve<T>(classes_.convolution, windows_, classes_.input.data(),
              values_.data() + classes_.weight, classes_.output.data());
  for (std::int64_t i = 0; i < windows_; ++i) {
    classes_.output.segment(i * logits_row(), logits_row()) += values_.segment(bias_, logits_row());
  }
  return classes_.output.data();
}

template <class T>
void WdcnnNetwork<T>::propagate_to_weight(const Layer& layer) {
  weight_gradient<T>(layer.convolution, windows_, layer.input.data(), output_gradient_.data(),
                     gradients_.data() + layer.weight);
}

template <class T>
void WdcnnNetwork<T>::propagate_to_input(const Layer& layer) {
  input_gradient<T>(layer.convolution, windows_, values_.data() + layer.weight,
                    output_gradient_.data(), transposed_.data(), pooled_gradient_.data());
}

template <class T>
BatchOutcome WdcnnNetwork<T>::backward(std::span<const Label> labels,
                                       std::span<const T> by_hidden) {
  const BatchOutcome outcome = cross_entropy<T>(number_of_classes_, logits_row(), labels,
                                                classes_.output.data(), output_gradient_.data());
  const auto labelled = std::ssize(labels) * logits_row();
  output_gradient_.segment(labelled, windows_ * logits_row() - labelled).setZero();
  gradients_.segment(bias_, logits_row()).setZero();
  for (std::int64_t i = 0; i < windows_; ++i) {
    gradients_.segment(bias_, logits_row()) +=
        output_gradient_.segment(i * logits_row(), logits_row());
  }
  propagate_to_weight(classes_);
  propagate_to_input(classes_);
  pooled_gradient_.head(std::ssize(by_hidden)) +=
      Eigen::Map<const Numbers>(by_hidden.data(), std::ssize(by_hidden));
  for (std::size_t i = layers_.size(); i-- > 0;) {
    NormalisedLayer& layer = layers_[i];
    normalise_and_pool_gradient<T>(
        pooled_shape(layer), layer.output.data(), normalisation(layer), pooled_gradient_.data(),
        output_gradient_.data(), gradients_.data() + layer.scale, gradients_.data() + layer.shift);
    propagate_to_weight(layer);
    if (i > 0) propagate_to_input(layer);
  }
  return outcome;
}

template <class T>
WdcnnWeights WdcnnNetwork<T>::weights() const {
  WdcnnWeights weights{.length = length_,
                       .classes = number_of_classes_,
                       .parameters = {},
                       .running_means = {},
                       .running_variances = {}};
  for (const WdcnnParameter& parameter : layout_) {
    parameter.for_each([&](std::int64_t /*i*/, std::int64_t j) {
      weights.parameters.push_back(static_cast<float>(values_[j]));
    });
  }
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const auto without_filling = [&](std::span<const T> all) {
      const std::span<const T> channels = all.first(layer_channels(i));
      return std::vector<float>(channels.begin(), channels.end());
    };
    weights.running_means.push_back(without_filling(running_mean(i)));
    weights.running_variances.push_back(without_filling(running_variance(i)));
  }
  return weights;
}

template <class T>
void WdcnnNetwork<T>::set(const WdcnnWeights& weights) {
  auto next = weights.parameters.begin();
  for (const WdcnnParameter& parameter : layout_) {
    parameter.for_each([&](std::int64_t /*i*/, std::int64_t j) { values_[j] = *next++; });
  }
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    std::ranges::copy(weights.running_means.at(i), layers_[i].running_mean.begin());
    std::ranges::copy(weights.running_variances.at(i), layers_[i].running_variance.begin());
  }
}

template class WdcnnNetwork<float>;
template class WdcnnNetwork<double>;

}  // namespace piae::diagnosis
