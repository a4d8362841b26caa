#include "diffusion/denoiser.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/vector.hpp"
#include "nets/dilated_convolution.hpp"
#include "nets/gradient_array.hpp"
#include "nets/position_dense.hpp"
#include "nets/relu.hpp"
#include "nets/residual.hpp"
#include "nets/row_array.hpp"
#include "nets/sequence_chain.hpp"
#include "nets/sequence_network.hpp"

namespace piae::diffusion {

namespace {

constexpr std::int64_t dilations = 6;  // 1 to 32 frames

std::string convolution_name(std::int64_t block, int convolution) {
  return fmt::format("block{}/conv{}", block, convolution);
}

template <class T>
std::unique_ptr<nets::SequenceLayer<T>> residual_block(nets::GradientArray<T>& parameters,
                                                       const nets::SequenceShape& shape,
                                                       std::int64_t block) {
  const nets::DilatedTaps taps{.kernel = Denoiser::kernel, .dilation = Denoiser::dilation(block)};
  const auto convolution = [&](int which) {
    return std::make_unique<nets::DilatedConvolution<T>>(parameters, convolution_name(block, which),
                                                         shape.length, taps);
  };
  const auto relu = [&] { return std::make_unique<nets::Relu<T>>(shape); };
  return std::make_unique<nets::Residual<T>>(std::make_unique<nets::SequenceChain<T>>(
      nets::layers<T>(relu(), convolution(0), relu(), convolution(1))));
}

}  // namespace

std::int64_t Denoiser::dilation(std::int64_t block) {
  return std::int64_t{1} << (block % dilations);
}

void require_whole_frames(std::size_t samples) {
  if (samples % Denoiser::frame == 0) return;
  throw Error(Exit::bad_input,
              fmt::format("windows of {} samples are not whole frames of {}; use another length "
                          "(split --window)",
                          samples, Denoiser::frame));
}

std::array<double, Denoiser::features> features_of(double u) {
  std::array<double, Denoiser::features> features{};
  for (std::size_t i = 0; i < features.size(); i += 2) {
    const double angle = u * std::numbers::pi / 2 * static_cast<double>(1U << (i / 2));
    features.at(i) = std::sin(angle);
    features.at(i + 1) = std::cos(angle);
  }
  return features;
}

std::vector<nets::ParameterSpec> denoiser_specs(const Denoiser& denoiser) {
  const std::int64_t channels = denoiser.size.channels;
  std::vector<nets::ParameterSpec> specs =
      nets::dense_specs(denoiser.name + "/frames", denoiser.inputs(), channels);
  for (std::int64_t block = 0; block < denoiser.size.blocks; ++block) {
    for (const int which : {0, 1}) {
      nets::append(specs, nets::dilated_convolution_specs(
                              denoiser.name + "/" + convolution_name(block, which), channels,
                              channels, Denoiser::kernel));
    }
  }
  nets::append(specs, nets::dense_specs(denoiser.name + "/velocity", channels, Denoiser::frame));
  return specs;
}

template <class T>
std::unique_ptr<nets::Network<T>> make_network(const Denoiser& denoiser,
                                               const std::shared_ptr<nets::Parameters<T>>& all,
                                               std::int64_t most_rows) {
  auto parameters = std::make_unique<nets::GradientArray<T>>(all, denoiser.name);
  const std::int64_t positions = denoiser.positions();
  const nets::SequenceShape shape{.length = positions, .width = denoiser.size.channels};
  auto layers =
      nets::layers<T>(std::make_unique<nets::PositionDense<T>>(*parameters, "frames", positions));
  for (std::int64_t block = 0; block < denoiser.size.blocks; ++block) {
    layers.push_back(residual_block<T>(*parameters, shape, block));
  }
  layers.push_back(std::make_unique<nets::PositionDense<T>>(*parameters, "velocity", positions));
  return std::make_unique<nets::SequenceNetwork<T>>(
      std::move(parameters), std::make_unique<nets::SequenceChain<T>>(std::move(layers)),
      most_rows);
}

template <class T>
void fill_input(const Denoiser& denoiser, const float* window, double u, std::optional<Label> label,
                T* row) {
  const auto features = features_of(u);
  const std::int64_t held = whole_rows(denoiser.inputs());
  for (std::int64_t t = 0; t < denoiser.positions(); ++t, row += held) {
    T* next = std::copy_n(window + t * Denoiser::frame, Denoiser::frame, row);
    next = std::ranges::transform(features, next, [](double x) { return static_cast<T>(x); }).out;
    std::fill_n(next, held - Denoiser::frame - Denoiser::features, T{0});
    if (label && denoiser.classes > 0) next[*label] = 1;
  }
}

template std::unique_ptr<nets::Network<float>> make_network(
    const Denoiser&, const std::shared_ptr<nets::Parameters<float>>&, std::int64_t);
template std::unique_ptr<nets::Network<double>> make_network(
    const Denoiser&, const std::shared_ptr<nets::Parameters<double>>&, std::int64_t);
template void fill_input(const Denoiser&, const float*, double, std::optional<Label>, float*);
template void fill_input(const Denoiser&, const float*, double, std::optional<Label>, double*);

}  // namespace piae::diffusion
