#pragma once

#include <torch/torch.h>

#include <numbers>
#include <vector>

// A second implementation of diffusion and flow, written from the articles with LibTorch's layers
// alone. It shares no code with src/, and differs where the articles permit it: noise instead of
// velocity is estimated, on 1000 discrete steps; a flow runs from noise to data.
namespace piae::plain {

/// Dilated residual convolutions over a periodic window. Place and class are further channels.
class NetworkImpl : public torch::nn::Module {
 public:
  explicit NetworkImpl(std::int64_t classes) : classes_(classes) {
    const auto convolution = [](std::int64_t in, std::int64_t out, std::int64_t dilation) {
      return torch::nn::Conv1d(torch::nn::Conv1dOptions(in, out, 5)
                                   .dilation(dilation)
                                   .padding(2 * dilation)
                                   .padding_mode(torch::kCircular));
    };
    first_ = register_module("first", convolution(1 + waves + classes, width, 1));
    for (const std::int64_t dilation : {1, 2, 4}) {
      blocks_.push_back(
          register_module("block" + std::to_string(dilation), convolution(width, width, dilation)));
    }
    last_ = register_module("last", convolution(width, 1, 1));
  }

  /// Takes windows [n, N], places [n] from 0 to 1, and classes [n]; returns [n, N].
  torch::Tensor forward(const torch::Tensor& x, const torch::Tensor& place,
                        const torch::Tensor& label) {
    std::vector<torch::Tensor> context;
    for (int k = 0; k < waves / 2; ++k) {
      context.push_back(torch::sin(place * std::numbers::pi * (k + 0.5)));
      context.push_back(torch::cos(place * std::numbers::pi * (k + 0.5)));
    }
    const torch::Tensor known = torch::cat(
        {torch::stack(context, 1), torch::one_hot(label, classes_).to(torch::kFloat)}, 1);
    const torch::Tensor wide = known.unsqueeze(2).expand({-1, -1, x.size(1)});
    torch::Tensor hidden = torch::silu(first_(torch::cat({x.unsqueeze(1), wide}, 1)));
    for (auto& block : blocks_) hidden = hidden + torch::silu(block(hidden));
    return last_(hidden).squeeze(1);
  }

 private:
  static constexpr int waves = 8;
  static constexpr std::int64_t width = 48;
  std::int64_t classes_;
  torch::nn::Conv1d first_{nullptr}, last_{nullptr};
  std::vector<torch::nn::Conv1d> blocks_;
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
    const torch::Tensor chosen = torch::randint(windows.size(0), {32}, torch::kLong);
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

/// Algorithm 1 of Ho, Jain and Abbeel 2020.
inline void train_noise(Network& network, const torch::Tensor& windows, const torch::Tensor& labels,
                        int steps) {
  const torch::Tensor alpha_bar = alpha_bars();
  train(network, windows, labels, steps, [&](const torch::Tensor& x0, const torch::Tensor& label) {
    const torch::Tensor t = torch::randint(1, steps_of_noise + 1, {x0.size(0)}, torch::kLong);
    const torch::Tensor share = alpha_bar.index_select(0, t).unsqueeze(1);
    const torch::Tensor noise = torch::randn_like(x0);
    const torch::Tensor x = share.sqrt() * x0 + (1 - share).sqrt() * noise;
    return torch::mse_loss(network(x, t.to(torch::kFloat) / steps_of_noise, label), noise);
  });
}

/// DDIM (Song, Meng and Ermon 2021, eq. 12 with sigma = 0), with the usual limits of the window
/// that a step expects, because the first steps divide by nearly nothing.
inline torch::Tensor sample_noise(Network& network, torch::Tensor x, std::int64_t label,
                                  double most, std::int64_t steps) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor alpha_bar = alpha_bars();
  const torch::Tensor labels = torch::full({x.size(0)}, label, torch::kLong);
  for (std::int64_t step = steps; step > 0; --step) {
    const std::int64_t from = steps_of_noise * step / steps;
    const std::int64_t to = steps_of_noise * (step - 1) / steps;
    const double here = alpha_bar[from].item<double>();
    const double next = alpha_bar[to].item<double>();
    const torch::Tensor place =
        torch::full({x.size(0)}, static_cast<double>(from) / steps_of_noise);
    torch::Tensor noise = network(x, place, labels);
    const torch::Tensor x0 =
        ((x - std::sqrt(1 - here) * noise) / std::sqrt(here)).clamp(-most, most);
    noise = (x - std::sqrt(here) * x0) / std::sqrt(1 - here);
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
