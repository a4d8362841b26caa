#include "augment/latent_specs.hpp"
#include "augment/libtorch_latent.hpp"
#include "augment/vae_backends.hpp"
#include "augment/vae_losses.hpp"
#include "nets/adam.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

namespace {

const std::string adam_group = "/adam/networks";

class LibtorchVae final : public LibtorchLatent {
 public:
  LibtorchVae(const LatentTask& task, const Stream& initial, const std::string& device)
      : LibtorchLatent(task, vae_specs(task.generator), initial, device),
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
  nets::Adam adam_;
};

}  // namespace

std::unique_ptr<LatentBackend> libtorch_vae(const LatentTask& task, const Stream& initial,
                                            const std::string& device) {
  return std::make_unique<LibtorchVae>(task, initial, device);
}

}  // namespace piae::augment
