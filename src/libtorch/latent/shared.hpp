#pragma once

#include <torch/types.h>

#include <span>
#include <string>
#include <vector>

#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// Known windows of a training step.
struct Batch {
  torch::Tensor windows;  ///< about their means, in units of their class's RMS, [n, N]
  torch::Tensor classes;  ///< one-hot, [n, classes]
};

/// z [n, latent] and one-hot classes [n, classes] -> windows [n, N], in units of the class's RMS.
torch::Tensor run_generator(const ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes);

/// What LibTorch's back ends of the VAE and the WGAN-GP share: parameters and known windows.
class LibtorchLatent : public latent::LatentBackend {
 public:
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override {
    return to_vector(parameters_.values());
  }
  void set_values(std::span<const float> values) override {
    copy_into(parameters_.values(), values);
  }

 protected:
  LibtorchLatent(const latent::LatentTask& task, std::vector<nets::ParameterSpec> specs,
                 const Stream& initial, Device device);

  ParameterSet& parameters() { return parameters_; }
  [[nodiscard]] double learning_rate() const { return learning_rate_; }
  [[nodiscard]] Batch batch_of(std::span<const std::size_t> windows) const;
  /// z of N(0, 1) for each window of the batch, [n, latent].
  [[nodiscard]] torch::Tensor draw_z(const Batch& batch, Stream& noise) const;

 private:
  std::int64_t latent_;
  double learning_rate_;
  std::vector<nets::ParameterSpec> specs_;
  Batch known_;
  ParameterSet parameters_;
};

}  // namespace piae::libtorch
