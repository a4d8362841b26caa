#include <gtest/gtest.h>

#include "seam/libtorch.hpp"

namespace piae::seam {
namespace {

// This test is linked with LibTorch.
TEST(BackEnds, ExistInAProgramLinkedWithLibtorch) {
  ASSERT_NE(back_ends(), nullptr);
  EXPECT_NE(back_end(&BackEnds::twin), nullptr);
  EXPECT_NE(back_end(&BackEnds::vae), nullptr);
  EXPECT_NE(back_end(&BackEnds::wgan_gp), nullptr);
  EXPECT_NE(back_end(&BackEnds::generator), nullptr);
  EXPECT_NE(back_end(&BackEnds::diffusion), nullptr);
  EXPECT_NE(back_end(&BackEnds::wdcnn), nullptr);
}

}  // namespace
}  // namespace piae::seam
