#include "nets/sequence_chain.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "nets/layer_gradients.hpp"
#include "nets/position_dense.hpp"
#include "nets/position_mean.hpp"
#include "nets/relu.hpp"
#include "nets/residual.hpp"

namespace piae::nets {
namespace {

// One row of 48 numbers becomes three positions of 16 numbers, the input of two further dense
// layers.
TEST(SequenceChain, HasTheGradientsOfFiniteDifferencesThroughDifferentShapes) {
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
