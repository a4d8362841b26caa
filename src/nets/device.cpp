#include "nets/device.hpp"

#include "base/compute.hpp"
#include "base/error.hpp"
#include "nets/torch.hpp"

namespace piae::nets {

torch::Device prepare_device(const std::string& name) {
  require_known_device(name);
  torch::set_num_threads(1);
  at::globalContext().setDeterministicAlgorithms(true, /*warn_only=*/true);
  if (name == "cpu") return torch::kCPU;
  if (!torch::cuda::is_available()) {
    throw Error(Exit::usage, "--device: this LibTorch finds no CUDA device; use cpu");
  }
  return torch::kCUDA;
}

}  // namespace piae::nets
