#include "nets/sequence_network.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "nets/position_dense.hpp"
#include "nets/row_array.hpp"

namespace piae::nets {
namespace {

using Array = RowArray<double>;

/// y = W x + b, with W = (2, -1) and b = 0.5.
struct OneUnit {
  explicit OneUnit(std::int64_t rows)
      : parameters(
            std::make_shared<Parameters<double>>(dense_specs("net/dense", 2, 1), Stream("test"))) {
    parameters->write(Parameters<double>::Kept::value, std::vector<float>{2, -1, 0.5F});
    auto gradients = std::make_unique<GradientArray<double>>(parameters, "net");
    auto layer = std::make_unique<PositionDense<double>>(*gradients, "dense", 1);
    network =
        std::make_unique<SequenceNetwork<double>>(std::move(gradients), std::move(layer), rows);
  }

  std::shared_ptr<Parameters<double>> parameters;
  std::unique_ptr<SequenceNetwork<double>> network;
};

TEST(SequenceNetwork, ReturnsTheGradientsOfTheRequestedRows) {
  OneUnit unit(4);
  Array x(2, 2);
  x << 3, 1, -1, 4;
  put(x, unit.network->input());
  Array expected(2, 1);
  expected << 5.5, -5.5;
  EXPECT_TRUE((copied(unit.network->forward(2), 2, 1) == expected).all());

  Array slopes(4, 1);  // two signals
  slopes << 1, 2, 10, 20;
  put(slopes, unit.network->output_gradient());
  Array by_input(2, 2);
  by_input << 4, -2, 20, -10;  // last row of the first signal, first row of the second
  EXPECT_TRUE((copied(unit.network->backward(2, 2, {1, 2}), 2, 2) == by_input).all());
  // W follows 1 x_0 + 2 x_1 = (1, 9), b follows 3.
  EXPECT_DOUBLE_EQ(unit.network->squared_norm(), 1 + 81 + 9);
}

TEST(SequenceNetwork, TakesStepsOfAdam) {
  OneUnit unit(1);
  put(Array(Array::Ones(1, 2)), unit.network->input());
  unit.network->forward(1);
  put(Array(Array::Constant(1, 1, -3)), unit.network->output_gradient());
  unit.network->backward(1, 1, no_rows);
  unit.network->take(AdamStep(1, 0.25), 1);
  const std::vector<float> after = unit.parameters->read(Parameters<double>::Kept::value);
  EXPECT_NEAR(after[0], 2.25, 1e-6);
  EXPECT_NEAR(after[1], -0.75, 1e-6);
  EXPECT_NEAR(after[2], 0.75, 1e-6);
}

TEST(SequenceNetwork, RefusesMoreRowsThanItsCapacity) {
  OneUnit unit(3);
  EXPECT_THROW(unit.network->forward(4), std::logic_error);
  unit.network->forward(2);
  EXPECT_THROW(unit.network->backward(2, 2, no_rows), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
