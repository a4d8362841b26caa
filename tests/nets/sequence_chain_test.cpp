// The layers that have no weights beside others, and how layers are put together.

#include "nets/sequence_chain.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "nets/layer_gradients.hpp"
#include "nets/position_copy.hpp"
#include "nets/position_dense.hpp"
#include "nets/position_mean.hpp"
#include "nets/position_table.hpp"
#include "nets/relu.hpp"
#include "nets/residual.hpp"

namespace piae::nets {
namespace {

constexpr SequenceShape three_by_sixteen{.length = 3, .width = 16};

template <class Layer>
LayerExample of_shape(const SequenceShape& shape) {
  return LayerExample([&](GradientArray<double>&) { return std::make_unique<Layer>(shape); });
}

TEST(PositionMean, IsTheMeanOverThePositions) {
  LayerExample example = of_shape<PositionMean<double>>({.length = 2, .width = 16});
  std::vector<double> x(2 * 16);
  x[3] = 5;
  x[16 + 3] = -2;
  EXPECT_EQ(example.forward(x, 1)[3], 1.5);
  expect_gradients_of_differences(example, 2);
}

TEST(PositionCopy, GivesEachPositionTheSame) {
  LayerExample example = of_shape<PositionCopy<double>>(three_by_sixteen);
  std::vector<double> x(2 * 16);
  x[2] = 7;
  x[16 + 2] = 8;
  const std::vector<double> y = example.forward(x, 2);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_EQ(y[t * 16 + 2], 7);
    EXPECT_EQ(y[(3 + t) * 16 + 2], 8);
  }
  expect_gradients_of_differences(example, 2);
}

TEST(PositionTable, AddsToEachPositionItsOwnNumbers) {
  LayerExample example(
      [](GradientArray<double>& parameters) {
        return std::make_unique<PositionTable<double>>(parameters, "positions");
      },
      position_table_specs("net/positions", three_by_sixteen));
  std::vector<float> values(3 * 16);
  values[16 + 4] = 2;
  example.parameters->write(Parameters<double>::Kept::value, values);
  const std::vector<double> y = example.forward(std::vector<double>(2 * 48, 1), 2);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(y[i], i % 48 == 16 + 4 ? 3 : 1) << i;
  expect_gradients_of_differences(example, 2);
}

TEST(Relu, LeavesWhatIsAboveZero) {
  LayerExample example = of_shape<Relu<double>>({.length = 1, .width = 16});
  std::vector<double> x(16, -1);
  x[5] = 2;
  const std::vector<double> y = example.forward(x, 1);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(y[i], i == 5 ? 2 : 0);
  expect_gradients_of_differences(example, 2);
}

TEST(Residual, AddsWhatWentIn) {
  LayerExample example([](GradientArray<double>&) {
    return std::make_unique<Residual<double>>(std::make_unique<Relu<double>>(three_by_sixteen));
  });
  EXPECT_EQ(example.forward(std::vector<double>(48, 2), 1), std::vector<double>(48, 4));
  EXPECT_EQ(example.forward(std::vector<double>(48, -2), 1), std::vector<double>(48, -2));
  expect_gradients_of_differences(example, 2);
}

// One row of 48 numbers becomes three positions of 16, which are read by turns of dense layers.
TEST(SequenceChain, HasTheGradientsOfFiniteDifferencesThroughOtherShapes) {
  std::vector<ParameterSpec> specs = dense_specs("net/all", 16, 48);
  append(specs, dense_specs("net/each", 16, 16));
  append(specs, dense_specs("net/last", 16, 16));
  LayerExample example(
      [](GradientArray<double>& parameters) {
        return std::make_unique<SequenceChain<double>>(layers<double>(
            std::make_unique<PositionDense<double>>(parameters, "all", 1),
            std::make_unique<Residual<double>>(std::make_unique<SequenceChain<double>>(
                layers<double>(std::make_unique<PositionDense<double>>(parameters, "each", 3),
                               std::make_unique<Relu<double>>(three_by_sixteen)))),
            std::make_unique<PositionMean<double>>(three_by_sixteen),
            std::make_unique<PositionDense<double>>(parameters, "last", 1)));
      },
      specs);
  EXPECT_EQ(example.layer->input(), (SequenceShape{.length = 1, .width = 16}));
  EXPECT_EQ(example.layer->output(), (SequenceShape{.length = 1, .width = 16}));
  for (const std::int64_t windows : {3, 1, 2}) expect_gradients_of_differences(example, windows);
}

TEST(SequenceChain, RefusesLayersThatDoNotFit) {
  using Chain = SequenceChain<double>;
  EXPECT_THROW(Chain({}), std::logic_error);
  EXPECT_THROW(Chain(layers<double>(std::make_unique<PositionMean<double>>(three_by_sixteen),
                                    std::make_unique<Relu<double>>(three_by_sixteen))),
               std::logic_error);
}

}  // namespace
}  // namespace piae::nets
