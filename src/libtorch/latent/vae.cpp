#include "latent/vae.hpp"

#include "latent/specs.hpp"
#include "libtorch/latent/backends.hpp"
#include "libtorch/latent/shared.hpp"
#include "libtorch/latent/vae_losses.hpp"
#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

const std::string adam_group = "/adam/networks";

class Vae final : public SharedBackend {
 public:
  Vae(const latent::LatentTask& task, const Stream& initial, Device device)
      : SharedBackend(task, latent::vae_specs(task.generator), initial, device),
        adam_(parameters().values(), parameters().gradients()) {}

  std::vector<double> step(std::size_t /*index*/, std::span<const std::size_t> windows,
                           Stream& noise) override {
    const Batch batch = batch_of(windows);
    const VaeLosses losses = vae_losses(parameters(), batch, draw_z(batch, noise));
    parameters().zero_gradients();
    (losses.squared_error + losses.kl).backward();
    adam_.step(learning_rate());
    return {losses.squared_error.item<double>(), losses.kl.item<double>()};
  }

  void write_adam(artefact::Writer& writer) const override { adam_.write(writer, adam_group); }
  void read_adam(const artefact::Reader& reader) override { adam_.read(reader, adam_group); }

 private:
  Adam adam_;
};

}  // namespace

std::unique_ptr<latent::LatentBackend> vae(latent::LatentTask task, const Stream& initial,
                                           Device device) {
  return std::make_unique<Vae>(task, initial, device);
}

}  // namespace piae::libtorch
