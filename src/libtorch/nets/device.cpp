#include "libtorch/nets/device.hpp"

#include "base/error.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

torch::Device prepare_device(Device device) {
  torch::set_num_threads(1);
  at::globalContext().setDeterministicAlgorithms(true, /*warn_only=*/true);
  if (device == Device::cpu) return torch::kCPU;
  if (!torch::cuda::is_available()) {
    throw Error(Exit::usage, "--device: this LibTorch finds no CUDA device; use cpu");
  }
  // With TF32, cuDNN's convolutions and recurrent layers would keep only ten bits of their factors.
  at::globalContext().setAllowTF32CuDNN(false);
  return torch::kCUDA;
}

}  // namespace piae::libtorch
