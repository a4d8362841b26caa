#include "libtorch/nets/device.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::nets {
namespace {

TEST(PrepareDevice, HoldsLibTorchToOneThread) {
  torch::set_num_threads(2);
  EXPECT_EQ(prepare_device("cpu"), torch::Device(torch::kCPU));
  EXPECT_EQ(torch::get_num_threads(), 1);
}

TEST(PrepareDevice, UnknownDeviceIsAUsageError) {
  try {
    prepare_device("tpu");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_STREQ(error.what(), "--device: unknown device 'tpu'; known are cpu and cuda");
  }
}

TEST(PrepareDevice, CudaWhereThereIsOne) {
  if (torch::cuda::is_available()) {
    EXPECT_EQ(prepare_device("cuda").type(), torch::kCUDA);
  } else {
    EXPECT_THROW(prepare_device("cuda"), Error);
  }
}

}  // namespace
}  // namespace piae::nets
