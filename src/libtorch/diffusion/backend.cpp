#include "libtorch/diffusion/backend.hpp"

#include <spdlog/fmt/fmt.h>

#include <numbers>
#include <vector>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/device.hpp"
#include "libtorch/nets/dilated.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

using diffusion::Denoiser;

class Diffusion final : public diffusion::DiffusionBackend {
 public:
  Diffusion(const diffusion::Networks& networks, const Stream& initial, Device device)
      : networks_(networks),
        specs_(specs_of(networks)),
        parameters_(specs_, initial, torch::kFloat32, prepare_device(device)) {
    for (const Denoiser& network : networks_) {
      adams_.emplace_back(parameters_.values(network.name + "/"),
                          parameters_.gradients(network.name + "/"));
    }
  }

  std::vector<float> velocities(const diffusion::NoisyBatch& batch, std::size_t networks) override {
    return to_vector(without_gradients(batch, networks));
  }

  double step(std::size_t trained, const diffusion::NoisyBatch& batch,
              std::span<const float> velocities, double learning_rate) override {
    const torch::Tensor unchanged = without_gradients(batch, trained);
    const torch::Tensor loss =
        (unchanged + sum_of(batch, trained, trained + 1) - rows(velocities, batch)).square().mean();
    parameters_.zero_gradients();
    loss.backward();
    clip_norm(parameters_.gradients(networks_[trained].name + "/"),
              diffusion::largest_gradient_norm);
    adams_[trained].step(learning_rate);
    return loss.item<double>();
  }

  [[nodiscard]] const std::vector<nets::ParameterSpec>& specs() const override { return specs_; }
  [[nodiscard]] std::vector<float> values() const override {
    return to_vector(parameters_.values());
  }
  void set_values(std::span<const float> values) override {
    copy_into(parameters_.values(), values);
  }
  void write_adam(artefact::Writer& writer) const override {
    for (std::size_t i = 0; i < adams_.size(); ++i) {
      adams_[i].write(writer, "/adam/" + networks_[i].name);
    }
  }
  void read_adam(const artefact::Reader& reader) override {
    for (std::size_t i = 0; i < adams_.size(); ++i) {
      adams_[i].read(reader, "/adam/" + networks_[i].name);
    }
  }

 private:
  [[nodiscard]] torch::Device device() const { return parameters_.values().device(); }
  [[nodiscard]] torch::Tensor rows(std::span<const float> numbers,
                                   const diffusion::NoisyBatch& batch) const {
    return torch::tensor(std::vector<float>(numbers.begin(), numbers.end()))
        .view({batch.size(), -1})
        .to(device());
  }
  [[nodiscard]] torch::Tensor classes_of(const diffusion::NoisyBatch& batch) const {
    torch::Tensor classes = torch::zeros({batch.size(), networks_.back().classes});
    for (std::int64_t i = 0; i < batch.size(); ++i) {
      const auto& label = batch.labels[static_cast<std::size_t>(i)];
      if (label) classes[i][*label] = 1;
    }
    return classes.to(device());
  }
  [[nodiscard]] torch::Tensor without_gradients(const diffusion::NoisyBatch& batch,
                                                std::size_t networks) const {
    const torch::NoGradGuard no_grad;
    return sum_of(batch, 0, networks);
  }
  /// Returns the sum of the velocities by the networks from `first` to before `last`.
  [[nodiscard]] torch::Tensor sum_of(const diffusion::NoisyBatch& batch, std::size_t first,
                                     std::size_t last) const {
    const torch::Tensor windows = rows(batch.windows, batch);
    const torch::Tensor u = torch::tensor(batch.u, torch::kFloat64);
    const torch::Tensor classes = classes_of(batch);
    torch::Tensor sum = torch::zeros_like(windows);
    for (std::size_t i = first; i < last; ++i) {
      sum = sum + run_denoiser(networks_[i], parameters_, windows, u, classes);
    }
    return sum;
  }

  diffusion::Networks networks_;
  std::vector<nets::ParameterSpec> specs_;
  ParameterSet parameters_;
  std::vector<Adam> adams_;
};

/// Returns the features of u, [n, features].
torch::Tensor features(const torch::Tensor& u) {
  std::vector<torch::Tensor> columns;
  for (std::int64_t i = 0; i < Denoiser::features; i += 2) {
    const torch::Tensor angle =
        u * (std::numbers::pi / 2 * static_cast<double>(std::int64_t{1} << (i / 2)));
    columns.push_back(angle.sin());
    columns.push_back(angle.cos());
  }
  return torch::stack(columns, 1);
}

}  // namespace

torch::Tensor run_denoiser(const Denoiser& denoiser, const ParameterSet& parameters,
                           const torch::Tensor& windows, const torch::Tensor& u,
                           const torch::Tensor& classes) {
  const std::int64_t n = windows.size(0);
  const auto at_each_frame = [&](const torch::Tensor& rows) {
    return rows.to(windows.device(), windows.scalar_type())
        .unsqueeze(1)
        .expand({n, denoiser.positions(), -1});
  };
  const torch::Tensor frames = torch::cat(
      {windows.view({n, denoiser.positions(), Denoiser::frame}), at_each_frame(features(u)),
       at_each_frame(classes.narrow(1, 0, denoiser.classes))},
      2);
  torch::Tensor x = run_dense(parameters, denoiser.name + "/frames", frames).transpose(1, 2);
  for (std::int64_t block = 0; block < denoiser.size.blocks; ++block) {
    torch::Tensor branch = x;
    for (const int which : {0, 1}) {
      branch = run_dilated_convolution(
          parameters, fmt::format("{}/block{}/conv{}", denoiser.name, block, which),
          torch::relu(branch), Denoiser::dilation(block));
    }
    x = x + branch;
  }
  return run_dense(parameters, denoiser.name + "/velocity", x.transpose(1, 2)).flatten(1);
}

std::unique_ptr<diffusion::DiffusionBackend> diffusion_backend(const diffusion::Networks& networks,
                                                               std::int64_t /*most_windows*/,
                                                               const Stream& initial,
                                                               Device device) {
  return std::make_unique<Diffusion>(networks, initial, device);
}

}  // namespace piae::libtorch
