#pragma once

#include <optional>

#include "augment/method.hpp"
#include "diffusion/options.hpp"
#include "diffusion/training.hpp"

namespace piae::augment {

/// Methods `ddpm` (denoising diffusion: Ho, Jain and Abbeel 2020) and `flow` (conditional flow
/// matching: Lipman et al. 2023), with the class as a condition, from the known windows; and
/// `ddpm-healthy`, whose network first learns the healthy windows and then stays as it is, while a
/// second one of half the size learns what a fault changes (as FaultDiffusion, arXiv 2511.15174,
/// keeps a model of normal data and adapts it; with few parameters it did worse). `ddpm-angle`,
/// `ddpm-healthy-angle` and `flow-angle` are the same with each known window read as its fault
/// cycle from a random angle, as `piae-dt-phase` draws it. pipeline/protocol.toml gives the source
/// of each setting.
class Diffusion final : public Method {
 public:
  enum class From { known, healthy };

  Diffusion(diffusion::Path path, From from, diffusion::Angle angle);

  [[nodiscard]] bool needs_libtorch(const Compute& compute) const override;
  void use_healthy(const signal::WindowSet& healthy) override { healthy_ = healthy; }
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  From from_;
  diffusion::Angle angle_;
  diffusion::DiffusionOptions options_;
  diffusion::HealthyOptions healthy_options_;
  std::optional<signal::WindowSet> healthy_;
};

}  // namespace piae::augment
