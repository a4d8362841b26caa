// Compares the chain's hand-written gradients with finite differences in double precision.

#include "nets/dense_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "nets/row_array.hpp"
#include "support/differences.hpp"
#include "support/random_array.hpp"

namespace piae::nets {
namespace {

using Chain = DenseChain<double>;
using Kept = Parameters<double>::Kept;
using Array = RowArray<double>;

constexpr std::int64_t inputs = 5;  // not a whole vector
constexpr std::int64_t outputs = 3;
constexpr std::int64_t width = 7;

struct Example {
  explicit Example(int depth = 3, std::int64_t rows = 30)
      : parameters(std::make_shared<Parameters<double>>(
            dense_chain_specs("net", inputs, outputs, {depth, static_cast<int>(width)}),
            Stream("initial"))),
        chain(parameters, "net", rows) {}

  Array forward(const Array& x) {
    put(x, chain.input());
    return copied(chain.forward(x.rows()), x.rows(), outputs);
  }
  /// Returns the gradient of sum(y * slope) by the input, for the y of the last forward().
  Array backward(const Array& slope) {
    put(slope, chain.output_gradient());
    return copied(chain.backward(slope.rows(), 1, {0, slope.rows()}), slope.rows(), inputs);
  }

  /// Calls f with each number of the parameters and its index in their array.
  void for_each_value(const std::function<void(double&, std::int64_t)>& f) {
    for (const auto& p : parameters->parameters()) {
      for (std::int64_t i = 0; i < p.rows; ++i) {
        for (std::int64_t j = 0; j < p.columns; ++j) {
          const std::int64_t at = p.begin + i * p.held_columns + j;
          f(parameters->data(Kept::value)[at], at);
        }
      }
    }
  }

  /// Returns the gradient that the chain would follow: Adam's first moment after its first step is
  /// a tenth of it. The values do not change.
  std::vector<double> gradient(const Chain::Summed& rows) {
    const std::vector<float> before = parameters->read(Kept::value);
    chain.take(AdamStep(1, 0), 1, rows);
    std::vector<double> all;
    for_each_value([&](double&, std::int64_t at) {
      all.push_back(10 * parameters->data(Kept::first_moment)[at]);
    });
    return all;
  }
  /// Returns central differences of a function of the parameters.
  std::vector<double> differences(const std::function<double()>& f) {
    std::vector<double> all;
    for_each_value(
        [&](double& value, std::int64_t) { all.push_back(central_difference(value, 1e-6, f)); });
    return all;
  }

  std::shared_ptr<Parameters<double>> parameters;
  Chain chain;
};

void expect_near(const std::vector<double>& mine, const std::vector<double>& expected) {
  ASSERT_EQ(mine.size(), expected.size());
  double largest = 0;
  for (const double x : expected) largest = std::max(largest, std::abs(x));
  EXPECT_GT(largest, 1e-3);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_NEAR(mine[i], expected[i], 1e-7 * largest) << i;
  }
}

TEST(DenseChain, AppliesReluBetweenLayersOnly) {
  const auto parameters =
      std::make_shared<Parameters<double>>(dense_chain_specs("net", 2, 2, {2, 2}), Stream("test"));
  const std::vector<float> values{1, -2, 3,  1,  0.5F, -1,  // first weight and bias
                                  1, 1,  -2, -1, 0,    1};  // second weight and bias
  parameters->write(Kept::value, values);
  Chain chain(parameters, "net", 2);
  Array x(2, 2);
  x << 1, 2, 2, 0;
  put(x, chain.input());
  // x = (1, 2): hidden (-2.5, 4), after ReLU (0, 4); out (4, -3). x = (2, 0): (2.5, 5); (7.5, -9).
  Array expected(2, 2);
  expected << 4, -3, 7.5, -9;
  EXPECT_TRUE((copied(chain.forward(2), 2, 2) == expected).all());
}

TEST(DenseChain, DoesNotUseLayersOfALongerName) {
  std::vector<ParameterSpec> specs = dense_chain_specs("a", 2, 2, {1, 2});
  append(specs, dense_chain_specs("ab", 2, 3, {1, 2}));
  const auto parameters = std::make_shared<Parameters<double>>(specs, Stream("test"));
  parameters->write(Kept::value, std::vector<float>{1, 0, 0, 1, 0, 0}, "a/");
  Chain chain(parameters, "a", 1);
  Array x(1, 2);
  x << 1, -2;
  put(x, chain.input());
  EXPECT_TRUE((copied(chain.forward(1), 1, 2) == x).all());
}

class DenseChains : public testing::TestWithParam<std::tuple<int, std::int64_t>> {};

TEST_P(DenseChains, HaveTheGradientsOfFiniteDifferences) {
  const auto [depth, rows] = GetParam();
  Example example(depth);
  Array x = random_array("x", rows, inputs);
  const Array slope = random_array("slope", rows, outputs);
  const auto value = [&] { return (example.forward(x) * slope).sum(); };
  const std::vector<double> expected = example.differences(value);
  std::vector<double> expected_by_x;
  for (double& number : x.reshaped<Eigen::RowMajor>()) {
    expected_by_x.push_back(central_difference(number, 1e-6, value));
  }
  value();
  const Array by_x = example.backward(slope);
  expect_near({by_x.data(), by_x.data() + by_x.size()}, expected_by_x);
  double squares = 0;
  for (const double g : expected) squares += g * g;
  EXPECT_NEAR(example.chain.squared_norm({rows, rows}), squares, 1e-6 * squares);
  expect_near(example.gradient({rows, rows}), expected);
}

// Fewer rows than a block of the kernels, one whole block, and several.
INSTANTIATE_TEST_SUITE_P(Nets, DenseChains,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(1, 2, 3, 4, 5, 6, 7, 12, 23)));

/// Returns the values and both moments of all parameters.
std::vector<float> all_kept(const Example& example) {
  std::vector<float> all;
  for (const Kept kept : {Kept::value, Kept::first_moment, Kept::second_moment}) {
    const std::vector<float> some = example.parameters->read(kept);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// 5 rows need one pass over a weight for going back and learning, 20 rows need two.
TEST_P(DenseChains, BackpropagateInOnePassAsInTwo) {
  const auto [depth, rows] = GetParam();
  for (const bool by_input : {true, false}) {
    Example two(depth);
    Example one(depth);
    for (int t = 1; t <= 2; ++t) {
      const Array x = random_array("x" + std::to_string(t), rows, inputs);
      const Array slope = random_array("slope" + std::to_string(t), rows, outputs);
      const AdamStep step(t, 0.01);
      two.forward(x);
      const Array expected = two.backward(slope);
      two.chain.take(step, 1);
      one.forward(x);
      put(slope, one.chain.output_gradient());
      const Array by_x = copied(one.chain.backward_and_take(step, by_input), rows, inputs);
      if (by_input) {
        EXPECT_TRUE((by_x == expected).all()) << t;
      }
    }
    EXPECT_EQ(all_kept(one), all_kept(two)) << by_input;
  }
}

TEST(DenseChain, PropagatesTwoSignalsOfOneBatchAtOnce) {
  constexpr std::int64_t rows = 5;
  Example both;
  Example alone;
  const Array x = random_array("x", rows, inputs);
  const Array first = random_array("first", rows, outputs);
  const Array second = random_array("second", rows, outputs);
  alone.forward(x);
  const Array expected = alone.backward(second);
  both.forward(x);
  put(first, both.chain.output_gradient());
  put(second, both.chain.output_gradient().from(rows));
  const Array by_x = copied(both.chain.backward(rows, 2, {rows, rows}), rows, inputs);
  EXPECT_LT((by_x - expected).abs().maxCoeff(), 1e-12);
  const std::vector<double> gradient = both.gradient({rows, rows});
  // Weights follow only the first signal.
  expect_near(gradient, both.differences([&] { return (both.forward(x) * first).sum(); }));
}

// A function of the gradient by the input, like a gradient penalty: half of its square, summed.
TEST(DenseChain, DifferentiatesAFunctionOfItsGradientByTheInput) {
  constexpr std::int64_t rows = 4;
  for (const int depth : {1, 2, 3, 4}) {
    Example example(depth);
    const Array x = random_array("x", rows, inputs);
    const Array slope = random_array("slope", rows, outputs);
    const auto by_input = [&] {
      example.forward(x);
      return example.backward(slope);
    };
    const std::vector<double> expected =
        example.differences([&] { return 0.5 * by_input().square().sum(); });
    put(by_input(), example.chain.input());  // the derivative of the half square
    example.chain.forward_derivative(0, rows);
    expect_near(example.gradient({.of_weights = rows, .of_biases = 0}), expected);
  }
}

TEST(DenseChain, ResultOfARowDoesNotDependOnOtherRows) {
  Example example;
  const Array x = random_array("x", 13, inputs);
  const Array all = example.forward(x);
  for (const std::int64_t i : {0, 5, 6, 12}) {
    EXPECT_TRUE((example.forward(x.row(i)) == all.row(i)).all()) << i;
  }
}

TEST(DenseChain, RefusesMoreRowsThanItsCapacity) {
  Example example(3, 4);
  EXPECT_THROW(example.chain.forward(5), std::logic_error);
  EXPECT_THROW(example.chain.backward(3, 2, no_rows), std::logic_error);
  EXPECT_THROW(example.chain.forward_derivative(2, 3), std::logic_error);
}

TEST(DenseChain, RefusesAnUnknownParameterName) {
  Example example;
  EXPECT_THROW(Chain(example.parameters, "another", 4), std::logic_error);
}

// Rows are padded to whole vectors, in values and in Adam's moments.
TEST(DenseChain, PaddingStaysZero) {
  Example example;
  const Array x = random_array("x", 5, inputs);
  const Array slope = random_array("slope", 5, outputs);
  for (int t = 1; t <= 3; ++t) {
    example.forward(x);
    example.backward(slope);
    example.chain.take(AdamStep(t, 1e-2), 1, {5, 5});
  }
  for (const Kept kept : {Kept::value, Kept::first_moment, Kept::second_moment}) {
    for (const auto& p : example.parameters->parameters()) {
      for (std::int64_t i = 0; i < p.rows; ++i) {
        for (std::int64_t j = p.columns; j < p.held_columns; ++j) {
          EXPECT_EQ(example.parameters->data(kept)[p.begin + i * p.held_columns + j], 0);
        }
      }
    }
  }
}

// See adam_test.cpp.
TEST(DenseChain, MomentsOfAZeroInputFadeToZero) {
#if !defined(__SSE__)
  GTEST_SKIP() << "this processor keeps denormal numbers";
#endif
  Example example(1);
  Array x = random_array("x", 2, inputs);
  const Array slope = random_array("slope", 2, outputs);
  const double& moment = *example.parameters->data(Kept::first_moment);  // moment of input 0
  for (int t = 1; t < 9000; ++t) {
    example.forward(x);
    example.backward(slope);
    example.chain.take(AdamStep(t, 1e-3), 1);
    if (t == 1) {
      EXPECT_NE(moment, 0);
    }
    x.col(0) = 0;
  }
  EXPECT_EQ(moment, 0);
}

}  // namespace
}  // namespace piae::nets
