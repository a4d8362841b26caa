#pragma once

// Compares a layer's hand-written gradients with finite differences in double precision.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "support/differences.hpp"

namespace piae::nets {

inline std::vector<double> random_numbers(const std::string& name, std::int64_t count) {
  Stream stream(name);
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& x : numbers) x = stream.normal(0, 1);
  return numbers;
}

/// A layer whose parameters, if it has any, are net/...
struct LayerExample {
  using Make = std::function<std::unique_ptr<SequenceLayer<double>>(GradientArray<double>&)>;

  explicit LayerExample(const Make& make, std::vector<ParameterSpec> specs = {})
      : parameters(
            std::make_shared<Parameters<double>>(with_one(std::move(specs)), Stream("initial"))),
        gradients(parameters, "net"),
        layer(make(gradients)) {}

  /// Adds a parameter to empty specs, because a set of parameters needs at least one.
  static std::vector<ParameterSpec> with_one(std::vector<ParameterSpec> specs) {
    if (specs.empty()) specs.push_back({.name = "net/none", .shape = {1}});
    return specs;
  }

  std::vector<double> forward(const std::vector<double>& x, std::int64_t windows) const {
    std::vector<double> y(static_cast<std::size_t>(windows * layer->output().size()));
    layer->forward(windows, x.data(), y.data());
    return y;
  }

  std::shared_ptr<Parameters<double>> parameters;
  GradientArray<double> gradients;
  std::unique_ptr<SequenceLayer<double>> layer;
};

inline void expect_near(double mine, double expected, double largest, const std::string& where) {
  EXPECT_NEAR(mine, expected, 1e-8 * (1 + largest)) << where;
}

/// Checks the gradients of sum(y * slope) for two slopes, the signals: those by the input for both,
/// and those of the parameters for the first only.
inline void expect_gradients_of_differences(LayerExample& example, std::int64_t windows) {
  SequenceLayer<double>& layer = *example.layer;
  std::vector<double> x = random_numbers("x", windows * layer.input().size());
  const std::int64_t outputs = windows * layer.output().size();
  const std::vector<double> slopes = random_numbers("slopes", 2 * outputs);
  const auto value = [&](std::int64_t signal) {
    const std::vector<double> y = example.forward(x, windows);
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      sum += y[i] * slopes[static_cast<std::size_t>(signal * outputs) + i];
    }
    return sum;
  };
  std::vector<double> by_x(2 * x.size(), NAN);
  example.forward(x, windows);
  layer.backward({.windows = windows, .signals = 2}, x.data(), slopes.data(), by_x.data());
  for (std::int64_t signal = 0; signal < 2; ++signal) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double slope = central_difference(x[i], 1e-5, [&] { return value(signal); });
      expect_near(
          by_x[static_cast<std::size_t>(signal) * x.size() + i], slope, std::abs(slope),
          "by number " + std::to_string(i) + " of the input, signal " + std::to_string(signal));
    }
  }
  for (const auto& parameter : example.parameters->parameters()) {
    if (parameter.spec.name == "net/none") continue;
    const TrainedParameter<double> trained =
        example.gradients.find(parameter.spec.name.substr(std::string("net/").size()));
    double* const values =
        example.parameters->data(Parameters<double>::Kept::value) + parameter.begin;
    for (std::int64_t i = 0; i < parameter.rows * parameter.held_columns; ++i) {
      const std::string where = parameter.spec.name + ' ' + std::to_string(i);
      if (i % parameter.held_columns >= parameter.columns) {
        EXPECT_EQ(trained.gradient[i], 0) << where;  // padding of the row
        continue;
      }
      const double slope = central_difference(values[i], 1e-5, [&] { return value(0); });
      expect_near(trained.gradient[i], slope, std::abs(slope), where);
    }
  }
}

/// An earlier, larger batch must change neither the output of a layer nor its gradients.
inline void expect_that_batches_leave_nothing_behind(const LayerExample::Make& make,
                                                     const std::vector<ParameterSpec>& specs) {
  constexpr std::int64_t windows = 2;
  const auto outcome = [&](bool after_another) {
    LayerExample example(make, specs);
    SequenceLayer<double>& layer = *example.layer;
    std::vector<double> all;
    for (const bool earlier : {true, false}) {
      if (earlier && !after_another) continue;
      const std::int64_t own = earlier ? 5 : windows;
      const std::string name = earlier ? "earlier " : "";
      const std::vector<double> x = random_numbers(name + "x", own * layer.input().size());
      const std::vector<double> dy = random_numbers(name + "dy", 2 * own * layer.output().size());
      std::vector<double> by_x(2 * x.size());
      all = example.forward(x, own);
      layer.backward({.windows = own, .signals = 2}, x.data(), dy.data(), by_x.data());
      all.insert(all.end(), by_x.begin(), by_x.end());
    }
    for (const ParameterSpec& spec : specs) {
      const TrainedParameter<double> trained =
          example.gradients.find(spec.name.substr(std::string("net/").size()));
      all.insert(all.end(), trained.gradient,
                 trained.gradient + trained.rows * trained.held_columns);
    }
    return all;
  };
  EXPECT_EQ(outcome(true), outcome(false));
}

/// Returns a layer without parameters, made from a shape.
template <class Layer>
LayerExample example_of_shape(const SequenceShape& shape) {
  return LayerExample([&](GradientArray<double>&) { return std::make_unique<Layer>(shape); });
}

inline constexpr SequenceShape three_by_sixteen{.length = 3, .width = 16};

}  // namespace piae::nets
