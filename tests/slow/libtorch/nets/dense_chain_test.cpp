// Compares our chain with LibTorch's autograd in double precision.

#include "nets/dense_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {
namespace {

using Chain = nets::DenseChain<double>;
using Kept = nets::Parameters<double>::Kept;
using nets::AdamStep;
using nets::ParameterSpec;
using nets::Rows;

constexpr std::int64_t inputs = 21;  // not a multiple of the vector width
constexpr std::int64_t outputs = 19;
constexpr double tolerance = 1e-12;

std::vector<ParameterSpec> example_specs(int depth = 3) {
  return nets::dense_chain_specs("net", inputs, outputs, {depth, 37});
}

torch::Tensor random_tensor(const std::string& name, std::int64_t rows, std::int64_t columns) {
  Stream stream(name);
  std::vector<double> values;
  for (std::int64_t i = 0; i < rows * columns; ++i) values.push_back(stream.normal(0, 1));
  return torch::tensor(values, torch::kFloat64).view({rows, columns});
}

/// Copies into the rows from `first` on.
void put(const torch::Tensor& from, Rows<double> to, std::int64_t first = 0) {
  for (std::int64_t i = 0; i < from.size(0); ++i) {
    for (std::int64_t j = 0; j < from.size(1); ++j) {
      to.row(first + i)[j] = from[i][j].item<double>();
    }
  }
}

torch::Tensor tensor_of(Rows<const double> rows, std::int64_t count, std::int64_t columns) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < count; ++i) {
    values.insert(values.end(), rows.row(i), rows.row(i) + columns);
  }
  return torch::tensor(values, torch::kFloat64).view({count, columns});
}

double difference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>() / b.abs().max().item<double>();
}

/// One chain in both implementations, with the same parameters.
struct Both {
  explicit Both(int depth = 3, std::int64_t rows = 30)
      : specs(example_specs(depth)),
        set(specs, Stream("initial"), torch::kFloat64),
        flat(std::make_shared<nets::Parameters<double>>(specs, Stream("initial"))),
        chain(flat, "net", rows) {}

  /// Returns the largest number in the padding of values and moments.
  double largest_filling() {
    double largest = 0;
    for (const Kept kept : {Kept::value, Kept::first_moment, Kept::second_moment}) {
      for (const auto& p : flat->parameters()) {
        for (std::int64_t i = 0; i < p.rows; ++i) {
          for (std::int64_t j = p.columns; j < p.held_columns; ++j) {
            largest =
                std::max(largest, std::abs(flat->data(kept)[p.begin + i * p.held_columns + j]));
          }
        }
      }
    }
    return largest;
  }

  /// Returns our gradient: ten times Adam's first moment after its first step.
  torch::Tensor gradient(const Chain::Summed& rows, double scale = 1) {
    chain.take(AdamStep(1, 1e-3), scale, rows);
    std::vector<double> all;
    for (const auto& parameter : flat->parameters()) {
      for (std::int64_t i = 0; i < parameter.rows; ++i) {
        const double* const row =
            flat->data(Kept::first_moment) + parameter.begin + i * parameter.held_columns;
        all.insert(all.end(), row, row + parameter.columns);
      }
    }
    return 10 * torch::tensor(all, torch::kFloat64);
  }

  /// Returns LibTorch's gradient, in the same order.
  torch::Tensor gradient_of(const torch::Tensor& value) {
    std::vector<torch::Tensor> all;
    for (const torch::Tensor& g : torch::autograd::grad({value}, set.with_prefix("net"), {},
                                                        /*retain_graph=*/true, false, true)) {
      all.push_back(g.reshape({-1}));
    }
    return torch::cat(all);
  }

  std::vector<ParameterSpec> specs;
  ParameterSet set;
  std::shared_ptr<nets::Parameters<double>> flat;
  Chain chain;
};

class DenseChains : public testing::TestWithParam<std::tuple<int, std::int64_t>> {};

TEST_P(DenseChains, MatchLibtorchForwardAndBackward) {
  const auto [depth, rows] = GetParam();
  Both both(depth);
  const torch::Tensor x = random_tensor("x", rows, inputs).requires_grad_();
  const torch::Tensor slope = random_tensor("slope", rows, outputs);
  put(x, both.chain.input());
  const torch::Tensor y = run_dense_chain(both.set, "net", x);
  EXPECT_LT(difference(tensor_of(both.chain.forward(rows), rows, outputs), y), tolerance);

  const torch::Tensor value = (y * slope).sum();
  put(slope, both.chain.output_gradient());
  const torch::Tensor by_x = tensor_of(both.chain.backward(rows, 1, {0, rows}), rows, inputs);
  EXPECT_LT(difference(by_x, torch::autograd::grad({value}, {x}, {}, true)[0]), tolerance);
  const torch::Tensor expected = both.gradient_of(value);
  EXPECT_NEAR(both.chain.squared_norm({rows, rows}), expected.square().sum().item<double>(),
              tolerance * expected.square().sum().item<double>());
  EXPECT_LT(difference(both.gradient({rows, rows}, 0.5), 0.5 * expected), tolerance);
}

// Tests fewer rows than a block of the kernels, one whole block, and several.
INSTANTIATE_TEST_SUITE_P(Nets, DenseChains,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(1, 2, 3, 4, 5, 6, 7, 12, 23)));

TEST(DenseChain, PropagatesTwoSignalsOfOneBatchAtOnce) {
  constexpr std::int64_t rows = 5;
  Both both;
  const torch::Tensor x = random_tensor("x", rows, inputs).requires_grad_();
  const torch::Tensor first = random_tensor("first", rows, outputs);
  const torch::Tensor second = random_tensor("second", rows, outputs);
  put(x, both.chain.input());
  both.chain.forward(rows);
  put(first, both.chain.output_gradient());
  put(second, both.chain.output_gradient(), rows);
  const torch::Tensor by_x = tensor_of(both.chain.backward(rows, 2, {rows, rows}), rows, inputs);
  const torch::Tensor y = run_dense_chain(both.set, "net", x);
  EXPECT_LT(difference(by_x, torch::autograd::grad({(y * second).sum()}, {x}, {}, true)[0]),
            tolerance);
  EXPECT_LT(difference(both.gradient({rows, rows}), both.gradient_of((y * first).sum())),
            tolerance);
}

// Uses half the sum of the squared input gradient, similar to a gradient penalty.
TEST(DenseChain, DifferentiatesAFunctionOfItsGradientByTheInput) {
  constexpr std::int64_t rows = 4;
  for (const int depth : {1, 2, 3, 4}) {
    Both both(depth);
    const torch::Tensor x = random_tensor("x", rows, inputs).requires_grad_();
    const torch::Tensor slope = random_tensor("slope", rows, outputs);
    put(x, both.chain.input());
    both.chain.forward(rows);
    put(slope, both.chain.output_gradient());
    const torch::Tensor by_x = tensor_of(both.chain.backward(rows, 1, {0, rows}), rows, inputs);
    put(by_x, both.chain.input());  // derivative of half the square
    both.chain.forward_derivative(0, rows);

    const torch::Tensor y = run_dense_chain(both.set, "net", x);
    const torch::Tensor gradient =
        torch::autograd::grad({(y * slope).sum()}, {x}, {}, true, true)[0];
    std::vector<torch::Tensor> expected;
    const std::vector<torch::Tensor> tensors = both.set.with_prefix("net");
    const auto exact = torch::autograd::grad({0.5 * gradient.square().sum()}, tensors, {}, false,
                                             false, /*allow_unused=*/true);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      expected.push_back(
          (exact[i].defined() ? exact[i] : torch::zeros_like(tensors[i])).reshape({-1}));
    }
    EXPECT_LT(difference(both.gradient({.of_weights = rows, .of_biases = 0}), torch::cat(expected)),
              tolerance)
        << depth;
  }
}

// Checks that padded rows of a weight take the same steps; adam_test.cpp tests Adam itself.
TEST(DenseChain, TakesTheStepsOfAdam) {
  Both both;
  const torch::Tensor x = random_tensor("x", 5, inputs);
  const torch::Tensor target = random_tensor("target", 5, outputs);
  Adam adam(both.set.values(), both.set.gradients());
  for (int t = 1; t <= 5; ++t) {
    const torch::Tensor error = run_dense_chain(both.set, "net", x) - target;
    both.set.zero_gradients();
    (0.5 * error.square()).sum().backward();
    adam.step(1e-2);
    put(x, both.chain.input());
    put(tensor_of(both.chain.forward(5), 5, outputs) - target, both.chain.output_gradient());
    both.chain.backward(5, 1, nets::no_rows);
    both.chain.take(AdamStep(t, 1e-2), 1, {5, 5});
  }
  const std::vector<float> mine = both.flat->read(Kept::value);
  const std::vector<float> theirs = to_vector(both.set.values());
  for (std::size_t i = 0; i < mine.size(); ++i) EXPECT_NEAR(mine[i], theirs[i], 1e-6) << i;
  EXPECT_EQ(both.largest_filling(), 0);
}

}  // namespace
}  // namespace piae::libtorch
