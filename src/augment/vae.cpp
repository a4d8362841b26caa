#include "augment/vae.hpp"

#include "augment/vae_losses.hpp"
#include "nets/adam.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

namespace {

const std::string adam_group = "/adam/networks";

/// Minimises the sum of the losses over all parameters.
class VaeTraining final : public LatentTraining {
 public:
  VaeTraining(const signal::WindowSet& known, const LatentOptions& options, const Stream& stream,
              const std::string& device)
      : LatentTraining(known, options, encoder_specs, {"squared_error", "kl"}, stream, device),
        adam_(parameters().values(), parameters().gradients()) {}

  void write_state(artefact::Writer& writer) const override {
    LatentTraining::write_state(writer);
    adam_.write(writer, adam_group);
  }

  void read_state(const artefact::Reader& reader) override {
    LatentTraining::read_state(reader);
    adam_.read(reader, adam_group);
  }

 private:
  std::vector<double> step(std::size_t /*index*/, const Batch& batch, Stream& noise) override {
    const VaeLosses losses = vae_losses(parameters(), batch, draw_z(batch, noise));
    parameters().zero_gradients();
    (losses.squared_error + losses.kl).backward();
    adam_.step(options().learning_rate);
    return {losses.squared_error.item<double>(), losses.kl.item<double>()};
  }

  nets::Adam adam_;
};

}  // namespace

void Vae::bind(const cli::Options& command) { augment::bind(command, options_); }

void Vae::train(const signal::WindowSet& known, const Stream& stream, const std::string& device,
                const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  VaeTraining training(known, options_, stream, device);
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet Vae::generate(const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const std::string& device) {
  return augment::generate(model, count, stream, device);
}

}  // namespace piae::augment
