#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "latent/options.hpp"

namespace piae::augment {

/// Settings of the VAE. The paper gives only its name; pipeline/protocol.toml, [train.vae], lists
/// the source of each value.
inline constexpr latent::LatentOptions vae_defaults{
    .epochs = 200,          // the paper's own networks, Table 4
    .batch = 5,             // Table 4
    .learning_rate = 5e-4,  // Table 4
    .latent = 10,           // calibrated
    .depth = 3,             // as PIAE-DT
    .width = 256,           // as PIAE-DT
};

/// Method `vae`: a conditional VAE on the known windows (Kingma and Welling 2014; the class is
/// given as in Sohn et al. 2015). The network after the last epoch generates.
class Vae final : public Method {
 public:
  [[nodiscard]] bool needs_libtorch(const Compute& compute) const override;
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  latent::LatentOptions options_ = vae_defaults;
};

}  // namespace piae::augment
