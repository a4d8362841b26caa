// The chain's gradients, written by hand, against finite differences in double precision.

#include "nets/recurrent_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "nets/recurrent_specs.hpp"
#include "nets/row_array.hpp"
#include "support/differences.hpp"

namespace piae::nets {
namespace {

using Recurrent = RecurrentChain<double>;
using Doubles = Parameters<double>;
using Matrix = RowArray<double>;

constexpr std::int64_t units_of_chain = 16;
constexpr std::int64_t frame_inputs = 5;  // no whole vector
constexpr std::int64_t frame_outputs = 3;

Matrix random_matrix(const std::string& name, std::int64_t rows, std::int64_t columns) {
  Stream stream(name);
  Matrix matrix(rows, columns);
  for (double& x : matrix.reshaped()) x = stream.normal(0, 1);
  return matrix;
}

struct RecurrentExample {
  explicit RecurrentExample(FrameCounts counts, std::int64_t layers = 2, std::int64_t most_rows = 8)
      : frames(counts),
        parameters(std::make_shared<Doubles>(
            recurrent_chain_specs("net", frame_inputs, frame_outputs,
                                  {.layers = layers, .units = units_of_chain}),
            Stream("initial"))),
        chain(parameters, "net", counts, most_rows) {}

  [[nodiscard]] std::int64_t inputs() const { return frames.input * frame_inputs; }
  [[nodiscard]] std::int64_t outputs() const { return frames.output * frame_outputs; }
  Matrix forward(const Matrix& x) {
    put(x, chain.input());
    return copied(chain.forward(x.rows()), x.rows(), outputs());
  }
  /// The gradient of sum(y * slope) by the input, for the y of the last forward().
  Matrix backward(const Matrix& slope) {
    put(slope, chain.output_gradient());
    return copied(chain.backward(slope.rows(), 1, {0, slope.rows()}), slope.rows(), inputs());
  }

  /// Calls f with each number of the parameters, and its place in their array.
  void for_each_value(const std::function<void(double&, std::int64_t)>& f) {
    for (const auto& p : parameters->parameters()) {
      for (std::int64_t i = 0; i < p.rows; ++i) {
        for (std::int64_t j = 0; j < p.columns; ++j) {
          const std::int64_t at = p.begin + i * p.held_columns + j;
          f(parameters->data(Doubles::Kept::value)[at], at);
        }
      }
    }
  }
  /// Adam's first moment after its first step is a tenth of the gradient.
  std::vector<double> gradient() {
    chain.take(AdamStep(1, 0), 1);
    std::vector<double> all;
    for_each_value([&](double&, std::int64_t at) {
      all.push_back(10 * parameters->data(Doubles::Kept::first_moment)[at]);
    });
    return all;
  }
  /// Central differences of a function of the parameters.
  std::vector<double> differences(const std::function<double()>& f) {
    std::vector<double> all;
    for_each_value(
        [&](double& value, std::int64_t) { all.push_back(central_difference(value, 1e-6, f)); });
    return all;
  }

  FrameCounts frames;
  std::shared_ptr<Doubles> parameters;
  Recurrent chain;
};

void expect_close(const std::vector<double>& mine, const std::vector<double>& expected) {
  ASSERT_EQ(mine.size(), expected.size());
  double largest = 0;
  for (const double x : expected) largest = std::max(largest, std::abs(x));
  EXPECT_GT(largest, 1e-3);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_NEAR(mine[i], expected[i], 1e-7 * largest) << i;
  }
}

/// A chain that reads a sequence, one that writes one, one that does both, and one of a frame.
const FrameCounts sequences[] = {{.input = 4, .output = 1},
                                 {.input = 1, .output = 4},
                                 {.input = 3, .output = 3},
                                 {.input = 1, .output = 1}};

/// r = s(x_r + h_r), z = s(x_z + h_z), n = tanh(x_n + r h_n), h' = (1 - z) n + z h (Cho et al.
/// 2014), here for unit 1 alone, over two frames.
TEST(RecurrentChain, ReadsItsFramesInTurn) {
  RecurrentExample example({.input = 2, .output = 1}, 1);
  example.for_each_value([](double& value, std::int64_t) { value = 0; });
  const auto set = [&](const std::string& name, std::int64_t row, std::int64_t column,
                       double value) {
    const auto& p = example.parameters->find("net/" + name);
    example.parameters->data(Doubles::Kept::value)[p.begin + row * p.held_columns + column] = value;
  };
  set("gru0/input_weight", 1, 0, 0.7);                       // r from input 0
  set("gru0/input_weight", units_of_chain + 1, 0, 0.5);      // z
  set("gru0/input_weight", 2 * units_of_chain + 1, 0, 1.0);  // n
  set("gru0/state_weight", 1, 1, 0.9);                       // r from the unit's own state
  set("gru0/state_weight", units_of_chain + 1, 1, -0.4);     // z
  set("gru0/state_weight", 2 * units_of_chain + 1, 1, 1.5);  // n
  set("gru0/input_bias", 0, 2 * units_of_chain + 1, 0.1);    // n
  set("gru0/state_bias", 0, 2 * units_of_chain + 1, 0.2);    // n, within r's reach
  set("dense/weight", 0, 1, 2.0);
  set("dense/bias", 0, 0, 0.25);
  Matrix x = Matrix::Zero(1, 2 * frame_inputs);
  x(0, 0) = 0.8;
  x(0, frame_inputs) = -0.6;
  double h = 0;
  for (const double in : {0.8, -0.6}) {
    const auto s = [](double v) { return 1 / (1 + std::exp(-v)); };
    const double r = s(0.7 * in + 0.9 * h);
    const double z = s(0.5 * in - 0.4 * h);
    const double n = std::tanh(in + 0.1 + r * (1.5 * h + 0.2));
    h = (1 - z) * n + z * h;
  }
  const Matrix y = example.forward(x);
  EXPECT_NEAR(y(0, 0), 2 * h + 0.25, 1e-14);
  EXPECT_EQ(y(0, 1), 0);
}

TEST(RecurrentChain, HasTheGradientsOfFiniteDifferences) {
  for (const FrameCounts frames : sequences) {
    for (const std::int64_t layers : {1, 2, 3}) {
      constexpr std::int64_t rows = 3;
      RecurrentExample example(frames, layers);
      Matrix x = random_matrix("x", rows, example.inputs());
      const Matrix slope = random_matrix("slope", rows, example.outputs());
      const auto value = [&] { return (example.forward(x) * slope).sum(); };
      const std::vector<double> expected = example.differences(value);
      std::vector<double> expected_by_x;
      for (double& number : x.reshaped<Eigen::RowMajor>()) {
        expected_by_x.push_back(central_difference(number, 1e-6, value));
      }
      value();
      const Matrix by_x = example.backward(slope);
      expect_close({by_x.data(), by_x.data() + by_x.size()}, expected_by_x);
      double squares = 0;
      for (const double g : expected) squares += g * g;
      EXPECT_NEAR(example.chain.squared_norm(), squares, 1e-6 * squares);
      expect_close(example.gradient(), expected);
    }
  }
}

TEST(RecurrentChain, PropagatesTwoSignalsOfOneBatch) {
  constexpr std::int64_t rows = 4;
  for (const FrameCounts frames : sequences) {
    RecurrentExample both(frames);
    RecurrentExample alone(frames);
    const Matrix x = random_matrix("x", rows, both.inputs());
    const Matrix first = random_matrix("first", rows, both.outputs());
    const Matrix second = random_matrix("second", rows, both.outputs());
    alone.forward(x);
    const Matrix by_first = alone.backward(first);
    const Matrix by_second = alone.backward(second);
    both.forward(x);
    put(first, both.chain.output_gradient());
    put(second, both.chain.output_gradient().from(rows));
    EXPECT_TRUE(
        (copied(both.chain.backward(rows, 2, {rows, rows}), rows, both.inputs()) == by_second)
            .all());
    // Of some rows of both.
    const Matrix some = copied(both.chain.backward(rows, 2, {1, rows}), rows, both.inputs());
    EXPECT_TRUE((some.topRows(rows - 1) == by_first.bottomRows(rows - 1)).all());
    EXPECT_TRUE((some.row(rows - 1) == by_second.row(0)).all());
    // Parameters follow the first signal alone.
    expect_close(both.gradient(),
                 both.differences([&] { return (both.forward(x) * first).sum(); }));
  }
}

TEST(RecurrentChain, ResultOfARowDoesNotDependOnTheRowsBesideIt) {
  for (const FrameCounts frames : sequences) {
    RecurrentExample example(frames);
    const Matrix x = random_matrix("x", 8, example.inputs());
    const Matrix all = example.forward(x);
    for (const std::int64_t i : {0, 5, 6, 7}) {
      EXPECT_TRUE((example.forward(x.row(i)) == all.row(i)).all()) << i;
    }
  }
}

// What the earlier batch left behind, which may have had more rows, changes nothing.
TEST(RecurrentChain, GradientsAreOfTheLastBatchAlone) {
  for (const FrameCounts frames : sequences) {
    RecurrentExample used(frames);
    RecurrentExample fresh(frames);
    used.forward(random_matrix("earlier", 8, used.inputs()));
    used.backward(random_matrix("earlier slope", 8, used.outputs()));
    const Matrix x = random_matrix("x", 3, used.inputs());
    const Matrix slope = random_matrix("slope", 3, used.outputs());
    EXPECT_TRUE((used.forward(x) == fresh.forward(x)).all());
    EXPECT_TRUE((used.backward(slope) == fresh.backward(slope)).all());
    EXPECT_EQ(used.gradient(), fresh.gradient());
  }
}

TEST(RecurrentChain, ScalesItsGradients) {
  RecurrentExample whole(sequences[0]);
  RecurrentExample half(sequences[0]);
  for (RecurrentExample* example : {&whole, &half}) {
    example->forward(random_matrix("x", 3, example->inputs()));
    example->backward(random_matrix("slope", 3, example->outputs()));
  }
  whole.chain.take(AdamStep(1, 0), 1);
  half.chain.take(AdamStep(1, 0), 0.5);
  whole.for_each_value([&](double&, std::int64_t at) {
    EXPECT_EQ(half.parameters->data(Doubles::Kept::first_moment)[at],
              0.5 * whole.parameters->data(Doubles::Kept::first_moment)[at]);
  });
}

TEST(RecurrentChain, WorksBesideOtherParametersThatStayAsTheyAre) {
  std::vector<ParameterSpec> specs = dense_specs("before", 3, 2);
  append(specs, recurrent_chain_specs("net", frame_inputs, frame_outputs, {1, units_of_chain}));
  append(specs, recurrent_chain_specs("net2", frame_inputs, frame_outputs, {2, units_of_chain}));
  const auto parameters = std::make_shared<Doubles>(specs, Stream("initial"));
  Recurrent chain(parameters, "net", {.input = 2, .output = 2}, 1);
  put(random_matrix("x", 1, 2 * frame_inputs), chain.input());
  chain.forward(1);
  put(random_matrix("slope", 1, 2 * frame_outputs), chain.output_gradient());
  chain.backward(1, 1, no_rows);
  const auto read = [&](const char* name) { return parameters->read(Doubles::Kept::value, name); };
  const std::vector<float> before = read("before/");
  const std::vector<float> own = read("net/");
  const std::vector<float> other = read("net2/");
  chain.take(AdamStep(1, 1e-2), 1);
  EXPECT_EQ(read("before/"), before);
  EXPECT_NE(read("net/"), own);
  EXPECT_EQ(read("net2/"), other);
}

TEST(RecurrentChain, HasNoRoomForMoreRowsThanItWasMadeFor) {
  RecurrentExample example(sequences[0], 1, 4);
  EXPECT_THROW(example.chain.forward(5), std::logic_error);
  EXPECT_THROW(example.chain.backward(3, 2, no_rows), std::logic_error);
}

TEST(RecurrentChain, RefusesParametersThatItCannotHave) {
  const RecurrentExample example(sequences[0]);
  EXPECT_THROW(Recurrent(example.parameters, "another", sequences[0], 4), std::logic_error);
  const auto odd = std::make_shared<Doubles>(
      recurrent_chain_specs("net", frame_inputs, frame_outputs, {1, units_of_chain + 1}),
      Stream("initial"));
  EXPECT_THROW(Recurrent(odd, "net", sequences[0], 4), std::logic_error);
}

// Rows are filled up to whole vectors, in values and in Adam's moments.
TEST(RecurrentChain, WhatFillsRowsUpStaysZero) {
  for (const FrameCounts frames : sequences) {
    RecurrentExample example(frames);
    for (int t = 1; t <= 3; ++t) {
      example.forward(random_matrix("x", 5, example.inputs()));
      example.backward(random_matrix("slope", 5, example.outputs()));
      example.chain.take(AdamStep(t, 1e-2), 1);
    }
    for (const auto kept :
         {Doubles::Kept::value, Doubles::Kept::first_moment, Doubles::Kept::second_moment}) {
      for (const auto& p : example.parameters->parameters()) {
        for (std::int64_t i = 0; i < p.rows; ++i) {
          for (std::int64_t j = p.columns; j < p.held_columns; ++j) {
            EXPECT_EQ(example.parameters->data(kept)[p.begin + i * p.held_columns + j], 0);
          }
        }
      }
    }
  }
}

TEST(RecurrentChain, ShowsThatItsInputIsNotANumber) {
  RecurrentExample example(sequences[0]);
  Matrix x = random_matrix("x", 2, example.inputs());
  x(1, 3) = std::numeric_limits<double>::quiet_NaN();
  const Matrix y = example.forward(x);
  EXPECT_TRUE(std::isfinite(y(0, 0)));
  EXPECT_TRUE(std::isnan(y(1, 0)));
}

}  // namespace
}  // namespace piae::nets
