#include "nets/transposition.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

// A length that is not a multiple of the squares' 16, and two windows.
TEST(Transposition, StoresChannelsOneAfterAnother) {
  LayerExample example = example_of_shape<Transposition<double>>({.length = 19, .width = 32});
  EXPECT_EQ(example.layer->output(), (SequenceShape{.length = 32, .width = 19}));
  const std::vector<double> x = random_numbers("x", std::int64_t{2} * 19 * 32);
  const std::vector<double> y = example.forward(x, 2);
  for (std::size_t w = 0; w < 2; ++w) {
    for (std::size_t t = 0; t < 19; ++t) {
      for (std::size_t c = 0; c < 32; ++c) {
        EXPECT_EQ(y[(w * 32 + c) * 19 + t], x[(w * 19 + t) * 32 + c]);
      }
    }
  }
}

TEST(Transposition, HasTheGradientsOfFiniteDifferences) {
  LayerExample example = example_of_shape<Transposition<double>>({.length = 3, .width = 16});
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
