// The chain by hand against LibTorch's gru with a dense layer behind it, by its autograd.

#include "nets/recurrent_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <tuple>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"
#include "nets/recurrent_specs.hpp"

namespace piae::libtorch {
namespace {

using nets::AdamStep;
using nets::FrameCounts;
using nets::Rows;

constexpr std::int64_t inputs = 21;  // no whole vector
constexpr std::int64_t outputs = 19;
constexpr std::int64_t units = 48;
constexpr std::int64_t most_rows = 30;

template <class T>
constexpr torch::ScalarType type_of = std::is_same_v<T, double> ? torch::kFloat64 : torch::kFloat32;
template <class T>
constexpr double tolerance = std::is_same_v<T, double> ? 1e-12 : 1e-5;

torch::Tensor random_tensor(const std::string& name, std::int64_t rows, std::int64_t columns,
                            torch::ScalarType type) {
  Stream stream(name);
  std::vector<double> values;
  for (std::int64_t i = 0; i < rows * columns; ++i) values.push_back(stream.normal(0, 1));
  return torch::tensor(values, torch::kFloat64).view({rows, columns}).to(type);
}

template <class T>
void put(const torch::Tensor& from, Rows<T> to) {
  const torch::Tensor packed = from.detach().contiguous();
  for (std::int64_t i = 0; i < from.size(0); ++i) {
    std::copy_n(packed.data_ptr<T>() + i * from.size(1), from.size(1), to.row(i));
  }
}

template <class T>
torch::Tensor tensor_of(Rows<const T> rows, std::int64_t count, std::int64_t columns) {
  const torch::Tensor tensor = torch::empty({count, columns}, type_of<T>);
  for (std::int64_t i = 0; i < count; ++i) {
    std::copy_n(rows.row(i), columns, tensor.data_ptr<T>() + i * columns);
  }
  return tensor;
}

double difference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>() / b.abs().max().item<double>();
}

/// One chain by both, with the same parameters.
template <class T>
struct Both {
  using Kept = typename nets::Parameters<T>::Kept;

  explicit Both(FrameCounts counts, std::int64_t chain_layers = 2)
      : frames(counts),
        layers(chain_layers),
        specs(nets::recurrent_chain_specs("net", inputs, outputs,
                                          {.layers = layers, .units = units})),
        set(specs, Stream("initial"), type_of<T>),
        flat(std::make_shared<nets::Parameters<T>>(specs, Stream("initial"))),
        chain(flat, "net", counts, most_rows) {}

  [[nodiscard]] torch::Tensor random_input(std::int64_t rows) const {
    return random_tensor("x", rows, frames.input * inputs, type_of<T>).requires_grad_();
  }
  [[nodiscard]] torch::Tensor random_slope(const std::string& name, std::int64_t rows) const {
    return random_tensor(name, rows, frames.output * outputs, type_of<T>);
  }

  [[nodiscard]] torch::Tensor run(const torch::Tensor& x) const {
    const std::int64_t length = std::max(frames.input, frames.output);
    const torch::Tensor given = x.view({x.size(0), frames.input, inputs});
    const torch::Tensor sequence = given.expand({-1, length, -1});
    const torch::Tensor states = std::get<0>(
        torch::gru(sequence, torch::zeros({layers, x.size(0), units}, x.options()),
                   set.with_prefix("net/gru"), true, layers, 0, true, false, /*batch_first=*/true));
    return run_dense(set, "net/dense", states.narrow(1, length - frames.output, frames.output))
        .flatten(1);
  }
  torch::Tensor run_mine(const torch::Tensor& x) {
    put<T>(x, chain.input());
    return tensor_of<T>(chain.forward(x.size(0)), x.size(0), frames.output * outputs);
  }

  /// Numbers that are kept of all parameters, without what fills up their rows.
  [[nodiscard]] torch::Tensor kept(Kept which) const {
    std::vector<torch::Tensor> all;
    for (const auto& p : flat->parameters()) {
      all.push_back(
          tensor_of<T>({flat->data(which) + p.begin, p.held_columns}, p.rows, p.columns).flatten());
    }
    return torch::cat(all);
  }
  /// Adam's first moment after its first step is a tenth of the gradient.
  torch::Tensor gradient(double scale) {
    chain.take(AdamStep(1, 0), scale);
    return 10 * kept(Kept::first_moment);
  }
  /// LibTorch's, in the same order.
  [[nodiscard]] torch::Tensor gradient_of(const torch::Tensor& value) const {
    std::vector<torch::Tensor> all;
    for (const torch::Tensor& g : torch::autograd::grad({value}, set.with_prefix("net"), {},
                                                        /*retain_graph=*/true)) {
      all.push_back(g.reshape({-1}));
    }
    return torch::cat(all);
  }

  FrameCounts frames;
  std::int64_t layers;
  std::vector<nets::ParameterSpec> specs;
  ParameterSet set;
  std::shared_ptr<nets::Parameters<T>> flat;
  nets::RecurrentChain<T> chain;
};

template <class T>
class RecurrentChains : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RecurrentChains, Precisions);

const FrameCounts sequences[] = {
    {.input = 32, .output = 1}, {.input = 1, .output = 32}, {.input = 7, .output = 7}};

TYPED_TEST(RecurrentChains, GiveWhatLibtorchGivesForwardAndBackward) {
  using T = TypeParam;
  for (const FrameCounts frames : sequences) {
    for (const std::int64_t layers : {1, 2, 3}) {
      for (const std::int64_t rows : {1, 2, 5, 6, 10, 23}) {
        Both<T> both(frames, layers);
        const torch::Tensor x = both.random_input(rows);
        const torch::Tensor slope = both.random_slope("slope", rows);
        const torch::Tensor y = both.run(x);
        EXPECT_LT(difference(both.run_mine(x), y), tolerance<T>);

        const torch::Tensor value = (y * slope).sum();
        put<T>(slope, both.chain.output_gradient());
        const torch::Tensor by_x =
            tensor_of<T>(both.chain.backward(rows, 1, {0, rows}), rows, frames.input * inputs);
        EXPECT_LT(difference(by_x, torch::autograd::grad({value}, {x}, {}, true)[0]), tolerance<T>);
        const torch::Tensor expected = both.gradient_of(value);
        const double squares = expected.to(torch::kFloat64).square().sum().template item<double>();
        EXPECT_NEAR(both.chain.squared_norm(), squares, tolerance<T> * squares);
        EXPECT_LT(difference(both.gradient(0.5), 0.5 * expected), tolerance<T>);
      }
    }
  }
}

TYPED_TEST(RecurrentChains, PropagateTwoSignalsOfOneBatch) {
  using T = TypeParam;
  constexpr std::int64_t rows = 5;
  for (const FrameCounts frames : sequences) {
    Both<T> both(frames);
    const torch::Tensor x = both.random_input(rows);
    const torch::Tensor first = both.random_slope("first", rows);
    const torch::Tensor second = both.random_slope("second", rows);
    both.run_mine(x);
    put<T>(torch::cat({first, second}), both.chain.output_gradient());
    const torch::Tensor by_x =
        tensor_of<T>(both.chain.backward(rows, 2, {rows, rows}), rows, frames.input * inputs);
    const torch::Tensor y = both.run(x);
    EXPECT_LT(difference(by_x, torch::autograd::grad({(y * second).sum()}, {x}, {}, true)[0]),
              tolerance<T>);
    EXPECT_LT(difference(both.gradient(1), both.gradient_of((y * first).sum())), tolerance<T>);
  }
}

// Adam divides by the root of its second moment, so that the last digits of a gradient near zero
// move a weight as far as any: steps leave fewer digits than a gradient.
TYPED_TEST(RecurrentChains, FollowLibtorchThroughStepsOfAdam) {
  using T = TypeParam;
  constexpr std::int64_t rows = 5;
  for (const FrameCounts frames : sequences) {
    Both<T> both(frames);
    const torch::Tensor x = both.random_input(rows).detach();
    const torch::Tensor target = both.random_slope("target", rows);
    Adam adam(both.set.values(), both.set.gradients());
    for (int t = 1; t <= 5; ++t) {
      both.set.zero_gradients();
      (0.5 * (both.run(x) - target).square()).sum().backward();
      adam.step(1e-3);
      put<T>(both.run_mine(x) - target, both.chain.output_gradient());
      both.chain.backward(rows, 1, nets::no_rows);
      both.chain.take(AdamStep(t, 1e-3), 1);
    }
    const double digits_lost = std::is_same_v<T, double> ? 1e2 : 1e1;
    EXPECT_LT(difference(both.kept(Both<T>::Kept::value), both.set.values()),
              digits_lost * tolerance<T>);
  }
}

}  // namespace
}  // namespace piae::libtorch
