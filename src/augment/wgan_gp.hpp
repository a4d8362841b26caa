#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "latent/wgan_gp_options.hpp"

namespace piae::augment {

/// The method `wgan-gp`: a conditional WGAN-GP on the known windows (Gulrajani et al. 2017,
/// "Improved training of Wasserstein GANs"). The network after the last epoch generates.
class WganGp final : public Method {
 public:
  [[nodiscard]] bool needs_libtorch(const Compute& compute) const override;
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  latent::WganGpOptions options_;
};

}  // namespace piae::augment
