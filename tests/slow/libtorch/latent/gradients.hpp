#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "libtorch/latent/shared.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

/// Returns a generator with three layers, five units wide.
inline latent::LatentGenerator example_generator(std::int64_t samples, std::size_t classes,
                                                 std::int64_t latent) {
  latent::LatentGenerator generator;
  generator.info.classes.resize(classes);
  generator.samples = samples;
  generator.latent = latent;
  generator.size = {3, 5};
  return generator;
}

inline ParameterSet double_parameters(const std::vector<nets::ParameterSpec>& specs) {
  return {specs, Stream("parameters"), torch::kFloat64};
}

inline torch::Tensor random_tensor(Stream& stream, std::int64_t rows, std::int64_t columns) {
  return torch::tensor(latent::normal_numbers(stream, static_cast<std::size_t>(rows * columns)))
      .view({rows, columns})
      .to(torch::kFloat64);
}

/// Returns random windows with alternating classes.
inline Batch example_batch(Stream& stream, std::int64_t n, std::int64_t samples,
                           std::int64_t classes) {
  const torch::Tensor labels = torch::arange(n).remainder(classes);
  return {random_tensor(stream, n, samples), torch::one_hot(labels, classes).to(torch::kFloat64)};
}

/// Returns the largest difference between autograd and central differences over the parameters that
/// start with the prefix, relative to the largest gradient.
inline double gradient_error(const ParameterSet& parameters, const std::string& prefix,
                             const std::function<torch::Tensor()>& loss) {
  std::vector<torch::Tensor> exact;
  for (const torch::Tensor& gradient :
       torch::autograd::grad({loss()}, parameters.with_prefix(prefix))) {
    exact.push_back(gradient.reshape({-1}));
  }
  const torch::Tensor gradients = torch::cat(exact);
  const torch::Tensor values = parameters.values(prefix);
  const auto at = [&](std::int64_t i, double value) {
    values[i] = value;
    return loss().item<double>();
  };
  const double step = 1e-6;
  double worst = 0;
  for (std::int64_t i = 0; i < values.numel(); ++i) {
    const auto old = values[i].item<double>();
    const double difference = (at(i, old + step) - at(i, old - step)) / (2 * step);
    values[i] = old;
    worst = std::max(worst, std::abs(difference - gradients[i].item<double>()));
  }
  return worst / gradients.abs().max().item<double>();
}

}  // namespace piae::libtorch
