#include "libtorch/nets/device.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {
namespace {

TEST(PrepareDevice, HoldsLibTorchToOneThread) {
  torch::set_num_threads(2);
  EXPECT_EQ(prepare_device(Device::cpu), torch::Device(torch::kCPU));
  EXPECT_EQ(torch::get_num_threads(), 1);
}

TEST(PrepareDevice, UsesCudaIfPresentAndRefusesItOtherwise) {
  if (torch::cuda::is_available()) {
    EXPECT_EQ(prepare_device(Device::cuda).type(), torch::kCUDA);
  } else {
    EXPECT_THROW(prepare_device(Device::cuda), Error);
  }
}

}  // namespace
}  // namespace piae::libtorch
