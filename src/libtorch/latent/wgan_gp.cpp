#include "latent/wgan_gp.hpp"

#include "latent/specs.hpp"
#include "libtorch/latent/backends.hpp"
#include "libtorch/latent/shared.hpp"
#include "libtorch/latent/wgan_gp_losses.hpp"
#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

namespace {

const std::string critic_prefix = latent::critic_name + "/";
const std::string generator_prefix = latent::generator_name + "/";

torch::Tensor uniform_column(Stream& stream, std::int64_t rows) {
  std::vector<float> numbers(static_cast<std::size_t>(rows));
  for (float& number : numbers) number = static_cast<float>(stream.uniform(0, 1));
  return torch::tensor(numbers).unsqueeze(1);
}

class WganGp final : public SharedBackend {
 public:
  WganGp(const latent::LatentTask& task, const latent::WganGpOptions& options,
         const Stream& initial, Device device)
      : SharedBackend(task, latent::wgan_gp_specs(task.generator), initial, device),
        critic_steps_(static_cast<std::size_t>(options.critic_steps)),
        lambda_(options.penalty),
        critic_adam_(adam_of(critic_prefix)),
        generator_adam_(adam_of(generator_prefix)) {}

  std::vector<double> step(std::size_t index, std::span<const std::size_t> windows,
                           Stream& noise) override {
    const Batch batch = batch_of(windows);
    const CriticLosses losses = step_critic(batch, noise);
    if ((index + 1) % critic_steps_ == 0) step_generator(batch, noise);
    return {losses.wasserstein.item<double>(), losses.penalty.item<double>()};
  }

  void write_adam(artefact::Writer& writer) const override {
    critic_adam_.write(writer, "/adam/critic");
    generator_adam_.write(writer, "/adam/generator");
  }
  void read_adam(const artefact::Reader& reader) override {
    critic_adam_.read(reader, "/adam/critic");
    generator_adam_.read(reader, "/adam/generator");
  }

 private:
  Adam adam_of(const std::string& prefix) {
    return {parameters().values(prefix), parameters().gradients(prefix), latent::wgan_gp_beta1,
            latent::wgan_gp_beta2};
  }

  CriticLosses step_critic(const Batch& batch, Stream& noise) {
    const torch::Tensor generated = generate(batch, noise).detach();
    const torch::Tensor share = uniform_column(noise, generated.size(0)).to(batch.windows.device());
    CriticLosses losses = critic_losses(parameters(), batch, generated, share);
    follow(critic_prefix, lambda_ * losses.penalty - losses.wasserstein);
    critic_adam_.step(learning_rate());
    return losses;
  }

  void step_generator(const Batch& batch, Stream& noise) {
    const torch::Tensor scores = run_critic(parameters(), generate(batch, noise), batch.classes);
    follow(generator_prefix, -scores.mean());
    generator_adam_.step(learning_rate());
  }

  torch::Tensor generate(const Batch& batch, Stream& noise) {
    return run_generator(parameters(), draw_z(batch, noise), batch.classes);
  }

  /// Sets the gradients of one network to those of a loss.
  void follow(const std::string& prefix, const torch::Tensor& loss) {
    parameters().set_gradients(prefix,
                               torch::autograd::grad({loss}, parameters().with_prefix(prefix)));
  }

  std::size_t critic_steps_;
  double lambda_;
  Adam critic_adam_;
  Adam generator_adam_;
};

}  // namespace

std::unique_ptr<latent::LatentBackend> wgan_gp(latent::LatentTask task,
                                               const latent::WganGpOptions& options,
                                               const Stream& initial, Device device) {
  return std::make_unique<WganGp>(task, options, initial, device);
}

}  // namespace piae::libtorch
