#include "latent/dense_backend.hpp"

#include <algorithm>
#include <utility>

#include "base/label.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::latent {

namespace {

using Parameters = nets::Parameters<float>;

class DenseGenerator final : public StoredGenerator {
 public:
  DenseGenerator(const LatentGenerator& generator, const std::shared_ptr<Parameters>& parameters)
      : generator_(generator), network_(parameters, generator_name, 1) {}

  [[nodiscard]] std::vector<float> make(std::span<const float> z, Label label) override {
    float* const input = network_.input().row(0);
    std::ranges::copy(z, input);
    nets::put_one_hot(label, generator_.classes(), input + generator_.latent);
    const float* const window = network_.forward(1).row(0);
    return {window, window + generator_.samples};
  }

 private:
  LatentGenerator generator_;
  nets::DenseChain<float> network_;
};

}  // namespace

DenseBackend::DenseBackend(LatentTask task, std::vector<nets::ParameterSpec> specs,
                           const Stream& initial)
    : task_(std::move(task)),
      specs_(std::move(specs)),
      parameters_(std::make_shared<Parameters>(specs_, initial)),
      largest_batch_(std::min<std::int64_t>(task_.options.batch, std::ssize(task_.labels))),
      generator_(parameters_, generator_name, largest_batch_) {}

DenseBackend::Batch DenseBackend::batch_of(std::span<const std::size_t> windows) const {
  Batch batch;
  batch.windows = nets::gathered<float>(task_.windows, task_.generator.samples, windows);
  for (const std::size_t i : windows) batch.labels.push_back(task_.labels[i]);
  return batch;
}

DenseBackend::Array DenseBackend::draw_z(const Batch& batch, Stream& noise) const {
  const std::int64_t latent = task_.generator.latent;
  const std::vector<float> numbers =
      normal_numbers(noise, static_cast<std::size_t>(batch.size() * latent));
  return Eigen::Map<const Array>(numbers.data(), batch.size(), latent);
}

void DenseBackend::feed(Chain& chain, const Array& rows, const Batch& batch,
                        std::int64_t first) const {
  nets::put(rows, chain.input().from(first));
  for (std::int64_t i = 0; i < rows.rows(); ++i) {
    nets::put_one_hot(batch.labels[static_cast<std::size_t>(i)], task_.generator.classes(),
                      chain.input().row(first + i) + rows.cols());
  }
}

DenseBackend::Array DenseBackend::generate(const Array& z, const Batch& batch) {
  feed(generator_, z, batch);
  return nets::copied(generator_.forward(batch.size()), batch.size(), task_.generator.samples);
}

std::unique_ptr<StoredGenerator> open_generator(const artefact::Reader& model,
                                                const LatentGenerator& generator,
                                                Device /*device*/) {
  const auto specs = generator_specs(generator);
  const std::vector<float> values = nets::read_parameters(model, weights_group, specs);
  const auto parameters = std::make_shared<Parameters>(specs, Stream("replaced"));
  parameters->write(Parameters::Kept::value, values);
  return std::make_unique<DenseGenerator>(generator, parameters);
}

}  // namespace piae::latent
