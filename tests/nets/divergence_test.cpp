#include "nets/divergence.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/errors.hpp"

namespace piae::nets {
namespace {

TEST(Divergence, NamesTheEpochAndTheOptionToChange) {
  for (const double loss :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_ERROR(
        require_finite(loss, "the inference of (k, c)", 3,
                       {.value = 0.5, .option = "--inference-learning-rate"}),
        Exit::failed,
        "the inference of (k, c) diverged in epoch 3 with --inference-learning-rate 0.5; use "
        "a smaller value");
  }
}

TEST(Divergence, IgnoresAFiniteLoss) {
  EXPECT_NO_THROW(require_finite(1e300, "training", 1, {.value = 1e-3}));
}

}  // namespace
}  // namespace piae::nets
