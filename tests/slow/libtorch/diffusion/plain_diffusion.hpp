#pragma once

#include <torch/torch.h>

#include <cmath>
#include <numbers>
#include <vector>

// A second implementation of diffusion and flow, written from the articles with LibTorch's layers
// alone. It shares no code with src/, and differs where the articles permit it: dense layers; the
// window is estimated, not the velocity, on 1000 discrete steps; a flow runs from noise to data.
namespace piae::plain {

/// Dense layers over the window, its place on the path, and its class.
class NetworkImpl : public torch::nn::Module {
 public:
  NetworkImpl(std::int64_t samples, std::int64_t classes)
      : classes_(classes),
        first_(register_module("first", torch::nn::Linear(samples + waves + classes, width))),
        second_(register_module("second", torch::nn::Linear(width, width))),
        third_(register_module("third", torch::nn::Linear(width, width))),
        last_(register_module("last", torch::nn::Linear(width, samples))) {}

  /// Takes windows [n, N], places [n] from 0 to 1, and classes [n]; returns [n, N].
  torch::Tensor forward(const torch::Tensor& x, const torch::Tensor& place,
                        const torch::Tensor& label) {
    std::vector<torch::Tensor> context;
    for (int k = 0; k < waves / 2; ++k) {
      context.push_back(torch::sin(place * std::numbers::pi * (k + 0.5)));
      context.push_back(torch::cos(place * std::numbers::pi * (k + 0.5)));
    }
    torch::Tensor hidden = torch::cat(
        {x, torch::stack(context, 1), torch::one_hot(label, classes_).to(torch::kFloat)}, 1);
    hidden = torch::silu(first_(hidden));
    hidden = hidden + torch::silu(second_(hidden));
    hidden = hidden + torch::silu(third_(hidden));
    return last_(hidden);
  }

 private:
  static constexpr int waves = 8;
  static constexpr std::int64_t width = 256;
  std::int64_t classes_;
  torch::nn::Linear first_, second_, third_, last_;
};
TORCH_MODULE(Network);

/// Trains by Adam on the loss of a batch of windows [n, N] with labels [n].
template <typename Loss>
void train(Network& network, const torch::Tensor& windows, const torch::Tensor& labels, int steps,
           Loss loss) {
  torch::optim::Adam adam(network->parameters(), 2e-3);
  for (int step = 0; step < steps; ++step) {
    for (auto& group : adam.param_groups()) {
      group.options().set_lr(2e-3 * (1 - static_cast<double>(step) / steps));
    }
    const torch::Tensor chosen = torch::randint(windows.size(0), {64}, torch::kLong);
    adam.zero_grad();
    loss(windows.index_select(0, chosen), labels.index_select(0, chosen)).backward();
    adam.step();
  }
}

constexpr std::int64_t steps_of_noise = 1000;

/// The cosine schedule: Nichol and Dhariwal 2021, eq. 17, with their offset of 0.008.
inline torch::Tensor alpha_bars() {
  const torch::Tensor t = torch::arange(steps_of_noise + 1).to(torch::kDouble) / steps_of_noise;
  const torch::Tensor f =
      torch::cos((t + 0.008) / 1.008 * std::numbers::pi / 2).square().clamp_min(1e-6);
  return (f / f[0]).to(torch::kFloat);
}

/// Algorithm 1 of Ho, Jain and Abbeel 2020, with the estimate of the window that their Section 3.2
/// mentions.
inline void train_diffusion(Network& network, const torch::Tensor& windows,
                            const torch::Tensor& labels, int steps) {
  const torch::Tensor alpha_bar = alpha_bars();
  train(network, windows, labels, steps, [&](const torch::Tensor& x0, const torch::Tensor& label) {
    const torch::Tensor t = torch::randint(1, steps_of_noise + 1, {x0.size(0)}, torch::kLong);
    const torch::Tensor share = alpha_bar.index_select(0, t).unsqueeze(1);
    const torch::Tensor x = share.sqrt() * x0 + (1 - share).sqrt() * torch::randn_like(x0);
    return torch::mse_loss(network(x, t.to(torch::kFloat) / steps_of_noise, label), x0);
  });
}

/// DDIM: Song, Meng and Ermon 2021, eq. 12 with sigma = 0.
inline torch::Tensor sample_diffusion(Network& network, torch::Tensor x, std::int64_t label,
                                      std::int64_t steps) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor alpha_bar = alpha_bars();
  const torch::Tensor labels = torch::full({x.size(0)}, label, torch::kLong);
  for (std::int64_t step = steps; step > 0; --step) {
    const std::int64_t from = steps_of_noise * step / steps;
    const double here = alpha_bar[from].item<double>();
    const double next = alpha_bar[steps_of_noise * (step - 1) / steps].item<double>();
    const torch::Tensor place =
        torch::full({x.size(0)}, static_cast<double>(from) / steps_of_noise);
    const torch::Tensor x0 = network(x, place, labels);
    const torch::Tensor noise = (x - std::sqrt(here) * x0) / std::sqrt(1 - here);
    x = std::sqrt(next) * x0 + std::sqrt(1 - next) * noise;
  }
  return x;
}

/// Conditional flow matching with optimal-transport paths (Lipman et al. 2023, eq. 23), from noise
/// at t = 0 to the window at t = 1.
inline void train_flow(Network& network, const torch::Tensor& windows, const torch::Tensor& labels,
                       int steps) {
  train(network, windows, labels, steps, [&](const torch::Tensor& x1, const torch::Tensor& label) {
    const torch::Tensor t = torch::rand({x1.size(0)});
    const torch::Tensor x0 = torch::randn_like(x1);
    const torch::Tensor x = (1 - t).unsqueeze(1) * x0 + t.unsqueeze(1) * x1;
    return torch::mse_loss(network(x, t, label), x1 - x0);
  });
}

/// Euler's method.
inline torch::Tensor sample_flow(Network& network, torch::Tensor x, std::int64_t label,
                                 std::int64_t steps) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor labels = torch::full({x.size(0)}, label, torch::kLong);
  for (std::int64_t step = 0; step < steps; ++step) {
    const torch::Tensor t = torch::full({x.size(0)}, static_cast<double>(step) / steps);
    x = x + network(x, t, labels) / static_cast<double>(steps);
  }
  return x;
}

}  // namespace piae::plain
