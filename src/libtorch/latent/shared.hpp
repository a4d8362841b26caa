#pragma once

#include <torch/types.h>

#include <span>
#include <string>
#include <vector>

#include "base/compute.hpp"
#include "latent/backend.hpp"
#include "libtorch/nets/parameters.hpp"

namespace piae::libtorch {

/// The known windows of a training step.
struct Batch {
  torch::Tensor windows;  ///< [n, N], each without its mean, in units of its class's RMS
  torch::Tensor classes;  ///< [n, classes], one-hot
};

/// Runs the generator: z [n, latent] and one-hot classes [n, classes] -> windows [n, N], in units
/// of the class's RMS.
torch::Tensor run_generator(const ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes);

/// Base of LibTorch's back ends of the VAE and the WGAN-GP. Owns the parameters and the known
/// windows.
class SharedBackend : public latent::LatentBackend {
 public:
  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override {
    return to_vector(parameters_.values());
  }
  void set_values(std::span<const float> values) override {
    copy_into(parameters_.values(), values);
  }

 protected:
  SharedBackend(const latent::LatentTask& task, std::vector<nets::ParameterSpec> specs,
                const Stream& initial, Device device);

  ParameterSet& parameters() { return parameters_; }
  [[nodiscard]] double learning_rate() const { return learning_rate_; }
  [[nodiscard]] Batch batch_of(std::span<const std::size_t> windows) const;
  /// Draws z from N(0, 1) for each window of the batch, [n, latent].
  [[nodiscard]] torch::Tensor draw_z(const Batch& batch, Stream& noise) const;

 private:
  std::int64_t latent_;  ///< numbers in z
  double learning_rate_;
  std::vector<nets::ParameterSpec> specs_;
  Batch known_;  ///< all known windows
  ParameterSet parameters_;
};

}  // namespace piae::libtorch
