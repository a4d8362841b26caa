#include "augment/wgan_gp.hpp"

#include "augment/wgan_gp_losses.hpp"
#include "nets/adam.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

namespace {

const std::string critic_prefix = "net/critic/";
const std::string generator_prefix = "net/generator/";

/// Adam's decay rates. Gulrajani et al. print beta_1 = 0 (Algorithm 1); their published code for
/// dense and small networks (gan_toy.py, gan_mnist.py) and most work since has 0.5.
constexpr double beta1 = 0.5;
constexpr double beta2 = 0.9;

torch::Tensor uniform_column(Stream& stream, std::int64_t rows) {
  std::vector<float> numbers(static_cast<std::size_t>(rows));
  for (float& number : numbers) number = static_cast<float>(stream.uniform(0, 1));
  return torch::tensor(numbers).unsqueeze(1);
}

/// The critic minimises -wasserstein + lambda * penalty in every step; after each `critic_steps` of
/// them, counted over the whole training, the generator takes one to maximise the mean score of its
/// windows (Gulrajani et al. 2017, Algorithm 1).
class WganGpTraining final : public LatentTraining {
 public:
  WganGpTraining(const signal::WindowSet& known, const WganGpOptions& options, const Stream& stream,
                 const std::string& device)
      : LatentTraining(known, options.networks, critic_specs, {"wasserstein", "gradient_penalty"},
                       stream, device),
        critic_steps_(static_cast<std::size_t>(options.critic_steps)),
        lambda_(options.penalty),
        critic_adam_(adam_of(critic_prefix)),
        generator_adam_(adam_of(generator_prefix)) {}

  void write_state(artefact::Writer& writer) const override {
    LatentTraining::write_state(writer);
    critic_adam_.write(writer, "/adam/critic");
    generator_adam_.write(writer, "/adam/generator");
  }

  void read_state(const artefact::Reader& reader) override {
    LatentTraining::read_state(reader);
    critic_adam_.read(reader, "/adam/critic");
    generator_adam_.read(reader, "/adam/generator");
  }

 private:
  nets::Adam adam_of(const std::string& prefix) {
    return {parameters().values(prefix), parameters().gradients(prefix), beta1, beta2};
  }

  std::vector<double> step(std::size_t index, const Batch& batch, Stream& noise) override {
    const CriticLosses losses = step_critic(batch, noise);
    if ((index + 1) % critic_steps_ == 0) step_generator(batch, noise);
    return {losses.wasserstein.item<double>(), losses.penalty.item<double>()};
  }

  CriticLosses step_critic(const Batch& batch, Stream& noise) {
    const torch::Tensor generated = generate(batch, noise).detach();
    const torch::Tensor share = uniform_column(noise, generated.size(0)).to(batch.windows.device());
    CriticLosses losses = critic_losses(parameters(), batch, generated, share);
    follow(critic_prefix, lambda_ * losses.penalty - losses.wasserstein);
    critic_adam_.step(options().learning_rate);
    return losses;
  }

  void step_generator(const Batch& batch, Stream& noise) {
    const torch::Tensor scores = run_critic(parameters(), generate(batch, noise), batch.classes);
    follow(generator_prefix, -scores.mean());
    generator_adam_.step(options().learning_rate);
  }

  torch::Tensor generate(const Batch& batch, Stream& noise) {
    return run_generator(parameters(), draw_z(batch, noise), batch.classes);
  }

  /// The gradient of a loss with respect to one of the two networks alone.
  void follow(const std::string& prefix, const torch::Tensor& loss) {
    parameters().set_gradients(prefix,
                               torch::autograd::grad({loss}, parameters().with_prefix(prefix)));
  }

  std::size_t critic_steps_;
  double lambda_;
  nets::Adam critic_adam_;
  nets::Adam generator_adam_;
};

}  // namespace

void bind(const cli::Options& command, WganGpOptions& o) {
  bind(command, o.networks);
  command.add("--critic-steps", o.critic_steps, "steps of the critic for each of the generator")
      .check(cli::positive_number());
  command.add("--penalty", o.penalty, "lambda, weight of the gradient penalty")
      .check(cli::non_negative_number());
}

void WganGp::bind(const cli::Options& command) { augment::bind(command, options_); }

void WganGp::train(const signal::WindowSet& known, const Stream& stream, const std::string& device,
                   const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  WganGpTraining training(known, options_, stream, device);
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet WganGp::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const std::string& device) {
  return augment::generate(model, count, stream, device);
}

}  // namespace piae::augment
