#include "latent/vae.hpp"

#include <utility>

#include "latent/dense_backend.hpp"
#include "latent/specs.hpp"
#include "nets/adam.hpp"

namespace piae::latent {

namespace {

const std::string adam_group = "/adam/networks";

class DenseVae final : public DenseBackend {
 public:
  DenseVae(LatentTask task, const std::vector<nets::ParameterSpec>& specs, const Stream& initial)
      : DenseBackend(std::move(task), specs, initial),
        encoder_(parameters_, encoder_name, largest_batch_) {}

  /// Follows the hand-written gradient of the sum of both losses.
  std::vector<double> step(std::size_t /*index*/, std::span<const std::size_t> windows,
                           Stream& noise) override {
    const Batch batch = batch_of(windows);
    const std::int64_t n = batch.size();
    const std::int64_t latent = task_.generator.latent;
    const float per_window = 1.0F / static_cast<float>(n);
    feed(encoder_, batch.windows, batch);
    const Array posterior = nets::copied(encoder_.forward(n), n, 2 * latent);
    const Array mean = posterior.leftCols(latent);
    const Array log_variance = posterior.rightCols(latent);
    const Array deviation = (0.5F * log_variance).exp() * draw_z(batch, noise);
    const Array error = generate(mean + deviation, batch) - batch.windows;

    nets::put<float>(error * per_window, generator_.output_gradient());
    const nets::AdamStep adam(++steps_, task_.options.learning_rate);
    const Array by_z = nets::copied(generator_.backward_and_take(adam, true), n, latent);
    nets::put<float>(by_z + mean * per_window, encoder_.output_gradient());
    nets::put<float>(0.5F * (by_z * deviation + (log_variance.exp() - 1) * per_window),
                     encoder_.output_gradient(), latent);
    encoder_.backward_and_take(adam, false);

    const Array kl = mean.square() + log_variance.exp() - 1 - log_variance;
    return {0.5 * static_cast<double>(error.square().sum() * per_window),
            0.5 * static_cast<double>(kl.sum() * per_window)};
  }

  void write_adam(artefact::Writer& writer) const override {
    write_moments(writer, adam_group, *parameters_, "net/", steps_);
  }
  void read_adam(const artefact::Reader& reader) override {
    steps_ = read_moments(reader, adam_group, *parameters_, "net/");
  }

 private:
  Chain encoder_;
  std::int64_t steps_ = 0;
};

}  // namespace

std::unique_ptr<LatentBackend> vae(LatentTask task, const Stream& initial, Device /*device*/) {
  const auto specs = vae_specs(task.generator);
  return std::make_unique<DenseVae>(std::move(task), specs, initial);
}

}  // namespace piae::latent
