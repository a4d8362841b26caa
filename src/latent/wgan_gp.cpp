#include "latent/wgan_gp.hpp"

#include <cmath>
#include <utility>

#include "latent/dense_backend.hpp"
#include "latent/specs.hpp"
#include "nets/adam.hpp"

namespace piae::latent {

namespace {

class DenseWganGp final : public DenseBackend {
 public:
  DenseWganGp(LatentTask task, const std::vector<nets::ParameterSpec>& specs,
              const WganGpOptions& options, const Stream& initial)
      : DenseBackend(std::move(task), specs, initial),
        critic_steps_(static_cast<std::size_t>(options.critic_steps)),
        lambda_(options.penalty),
        critic_(parameters_, critic_name, 3 * largest_batch_) {}

  std::vector<double> step(std::size_t index, std::span<const std::size_t> windows,
                           Stream& noise) override {
    const Batch batch = batch_of(windows);
    std::vector<double> losses = step_critic(batch, noise);
    if ((index + 1) % critic_steps_ == 0) step_generator(batch, noise);
    return losses;
  }

  void write_adam(artefact::Writer& writer) const override {
    write_moments(writer, "/adam/critic", *parameters_, critic_name, critic_taken_);
    write_moments(writer, "/adam/generator", *parameters_, generator_name, generator_taken_);
  }
  void read_adam(const artefact::Reader& reader) override {
    critic_taken_ = read_moments(reader, "/adam/critic", *parameters_, critic_name);
    generator_taken_ = read_moments(reader, "/adam/generator", *parameters_, generator_name);
  }

 private:
  /// Trains on one batch of 3 n windows: n known ones, n generated ones and n between them.
  std::vector<double> step_critic(const Batch& batch, Stream& noise) {
    const std::int64_t n = batch.size();
    const Array generated = generate(draw_z(batch, noise), batch);
    feed(critic_, batch.windows, batch);
    feed(critic_, generated, batch, n);
    feed(critic_, between(generated, batch.windows, noise), batch, 2 * n);
    const Array scores = nets::copied(critic_.forward(3 * n), 3 * n, 1);

    // For known and generated windows, the gradient is that of -wasserstein. The penalty needs the
    // gradient of the score by the window, so the windows between start from a gradient of 1.
    const auto share = 1 / static_cast<float>(n);
    for (std::int64_t i = 0; i < 3 * n; ++i) {
      *critic_.output_gradient().row(i) = i < n ? -share : i < 2 * n ? share : 1;
    }
    const Array slopes = nets::copied(critic_.backward(3 * n, 1, {.begin = 2 * n, .count = n}), n,
                                      task_.generator.samples);
    const double penalty = follow_penalty(slopes, batch);
    critic_.take(adam(++critic_taken_), 1, {.of_weights = 3 * n, .of_biases = 2 * n});
    return {static_cast<double>(scores.topRows(n).mean() - scores.middleRows(n, n).mean()),
            penalty};
  }

  /// Returns windows at random positions on the lines from generated to known windows.
  [[nodiscard]] static Array between(const Array& generated, const Array& known, Stream& noise) {
    Array windows(known.rows(), known.cols());
    for (std::int64_t i = 0; i < known.rows(); ++i) {
      const auto share = static_cast<float>(noise.uniform(0, 1));
      windows.row(i) = generated.row(i) + share * (known.row(i) - generated.row(i));
    }
    return windows;
  }

  /// Prepares the critic for a step that also follows the penalty; returns the penalty. The penalty
  /// is a function of the slopes g, the gradients of the critic's score by the windows between. g
  /// is linear in each weight: g = W_1^T m_1 W_2^T m_2 ..., where m_i is 1 for the units of layer i
  /// with a positive output and 0 for the others. So the gradient of the penalty by a weight is
  /// that of a layer whose input is the derivative of the penalty by g, propagated through the
  /// layers below (DenseChain::forward_derivative). Biases do not affect g.
  double follow_penalty(const Array& slopes, const Batch& batch) {
    const std::int64_t n = batch.size();
    double penalty = 0;
    Array by_slopes(n, slopes.cols());
    for (std::int64_t i = 0; i < n; ++i) {
      const auto norm = static_cast<double>(slopes.row(i).matrix().norm());
      penalty += (norm - 1) * (norm - 1) / static_cast<double>(n);
      const double factor = 2 * lambda_ * (norm - 1) / static_cast<double>(n);
      by_slopes.row(i) = slopes.row(i) * static_cast<float>(norm > 0 ? factor / norm : 0);
    }
    nets::put(by_slopes, critic_.input().from(2 * n));
    const Array no_classes = Array::Zero(n, task_.generator.classes());
    nets::put(no_classes, critic_.input().from(2 * n), task_.generator.samples);
    critic_.forward_derivative(2 * n, n);
    return penalty;
  }

  void step_generator(const Batch& batch, Stream& noise) {
    const std::int64_t n = batch.size();
    feed(critic_, generate(draw_z(batch, noise), batch), batch);
    critic_.forward(n);
    for (std::int64_t i = 0; i < n; ++i) {
      *critic_.output_gradient().row(i) = -1 / static_cast<float>(n);
    }
    nets::put(
        nets::copied(critic_.backward(n, 1, {.begin = 0, .count = n}), n, task_.generator.samples),
        generator_.output_gradient());
    generator_.backward_and_take(adam(++generator_taken_), false);
  }

  [[nodiscard]] nets::AdamStep adam(std::int64_t taken) const {
    return {taken, task_.options.learning_rate, wgan_gp_beta1, wgan_gp_beta2};
  }

  std::size_t critic_steps_;
  double lambda_;
  Chain critic_;
  std::int64_t critic_taken_ = 0;     ///< steps of the critic
  std::int64_t generator_taken_ = 0;  ///< steps of the generator
};

}  // namespace

std::unique_ptr<LatentBackend> wgan_gp(LatentTask task, const WganGpOptions& options,
                                       const Stream& initial, Device /*device*/) {
  const auto specs = wgan_gp_specs(task.generator);
  return std::make_unique<DenseWganGp>(std::move(task), specs, options, initial);
}

}  // namespace piae::latent
